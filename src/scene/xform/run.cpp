#include "scene/xform/run.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

#include "common/format.h"
#include "common/raypath.h"
#include "common/text_file.h"
#include "scene/command_pipe.h"
#include "scene/rad_parser.h"
#include "scene/warnings.h"
#include "scene/xform/output.h"
#include "scene/xform/primitive.h"
#include "scene/xform/repetition.h"
#include "scene/xform/settings.h"

namespace infra::xform {
namespace {

/// Commands within the output of commands, as in rad_reader.cpp.
constexpr int deepest_nesting = 64;

/// Single quotes keep everything from the shell but themselves.
std::string shell_quoted(const std::string& word) {
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return "";
    return path.substr(0, std::max<std::size_t>(slash, 1));
}

class Program {
  public:
    explicit Program(std::FILE* out) : output_(out), warn_(print_warnings("xform")) {}

    void call(const Settings& settings);
    void remark(const std::string& line) { output_.text(line + "\n"); }
    void finish() { output_.finish(); }

  private:
    void transform(const Settings& settings, TextSource source, const std::string& folder);
    void command(const Settings& settings, const std::string& line, const std::string& folder);

    Output output_;
    WarningSink warn_;
    std::optional<std::string> standard_input_;  // kept, as a repetition reads it again
    int nesting_ = 0;
};

void Program::call(const Settings& settings) {
    std::string title = "#";
    for (const std::string& word : std::span(settings.words).first(settings.transform_end))
        title += ' ' + word;
    output_.text(title + '\n');
    if (settings.files().empty()) {
        if (!standard_input_) standard_input_ = read_text_file("-");
        transform(settings, TextSource(*standard_input_, "standard input"), "");
    }
    for (const std::string& name : settings.files()) {
        std::string path = require_library_file(name, "scene file");
        if (path.starts_with("./")) path.erase(0, 2);
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "r"),
                                                                   std::fclose);
        if (!file) throw Error("cannot open \"" + path + "\": " + std::strerror(errno));
        transform(settings, TextSource(file.get(), path), folder_of(path));
    }
}

/// `folder`: where commands in the text are run; "" is here.
void Program::transform(const Settings& settings, TextSource source, const std::string& folder) {
    const std::string name = source.name();
    RadParser parser(std::move(source));
    bool empty = true;
    for (auto item = parser.next(); item != RadParser::Item::end; item = parser.next()) {
        if (item == RadParser::Item::comment) {
            output_.text(parser.text() + "\n");
            continue;
        }
        empty = false;
        if (item == RadParser::Item::command) {
            command(settings, parser.text(), folder);
        } else {
            ParsedPrimitive moved = parser.primitive();
            apply(settings, moved, parser.location());
            output_.primitive(moved);
        }
    }
    if (empty) warn_(name + ": empty file");
}

void Program::command(const Settings& settings, const std::string& line, const std::string& folder) {
    if (!settings.expand) {
        output_.text("\n" + line);
        if (settings.transform_end > 1) {
            std::vector<std::string> words = {settings.words[0], "-e"};
            for (std::size_t i = 1; i < settings.transform_end; ++i)
                if (i >= settings.transform_begin || settings.words[i] != "-c")
                    words.push_back(settings.words[i]);
            output_.text(" | " + join_command(words));
        }
        return output_.text("\n");
    }
    const std::string title = command_title(line);
    if (++nesting_ > deepest_nesting)
        throw Error(Location{title},
                    "commands run one another " + std::to_string(deepest_nesting) + " levels deep",
                    "does the file run a command that reads the file itself?");
    const std::string to_folder = folder.empty() ? "" : "cd " + shell_quoted(folder) + " && ";
    CommandPipe pipe(to_folder + line.substr(1));
    transform(settings, TextSource(pipe.stream(), title), folder);
    if (!pipe.close()) warn_("bad status from " + title);
    --nesting_;
}

}  // namespace

void run(const std::vector<std::string>& words, std::FILE* out) {
    Program program(out);
    for_each_call(words, {[&](std::vector<std::string> call) {
                              if (const auto settings = parse_settings(std::move(call)))
                                  program.call(*settings);
                          },
                          [&](const std::string& line) { program.remark(line); }});
    program.finish();
}

}  // namespace infra::xform
