// getinfo: prints, changes or removes the information header of a picture, octree or mesh. Of OpenEXR it
// prints what the file says about itself.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "common/error.h"
#include "common/format.h"
#include "common/pictures/exr_info.h"
#include "scene/getinfo_options.h"
#include "scene/info_header.h"
#include "scene/octree_format.h"

namespace infra {
namespace {

InfoHeader header_of_stdin() {
    const auto header = read_info_header(stdin);
    if (!header) throw Error(Location{"standard input"}, "bad header", "is it a picture, octree or mesh?");
    return *header;
}

std::string dimensions_of(std::FILE* file) { return read_dimensions(file).value_or("unknown file type"); }

void print_line(const std::string& line) { std::printf("%s\n", line.c_str()); }

/// The format stands last, as it tells how to read what follows.
void end_header(const std::string& format) {
    if (!format.empty()) std::printf("%.*s%s\n", int(format_key.size()), format_key.data(), format.c_str());
    std::putchar('\n');
}

void copy_data() {
    char buffer[8192];
    for (std::size_t n = std::fread(buffer, 1, sizeof buffer, stdin); n > 0;
         n = std::fread(buffer, 1, sizeof buffer, stdin))
        std::fwrite(buffer, 1, n, stdout);
}

/// -a: the header with more lines.
void append_lines(const std::vector<std::string>& added) {
    const InfoHeader header = header_of_stdin();
    for (const std::string& line : header.lines)
        if (!is_format_line(line)) print_line(line);
    for (const std::string& line : added)
        if (!line.empty()) std::printf("%s%s", line.c_str(), line.back() == '\n' ? "" : "\n");
    end_header(header.format());
    copy_data();
}

/// -r: the header with settings replaced, or taken out where only a name is given.
void replace_lines(const std::vector<std::string>& settings) {
    const InfoHeader header = header_of_stdin();
    for (const std::string& line : header.lines) {
        bool replaced = is_format_line(line);
        for (const std::string& setting : settings) replaced = replaced || sets_the_same(line, setting);
        if (!replaced) print_line(line);
    }
    for (std::string setting : settings) {
        const std::size_t begin = setting.find_first_not_of(" \t\n");
        if (begin == std::string::npos) continue;
        setting.erase(setting.find_last_not_of(" \t\n") + 1);
        const std::size_t value = setting.find_first_of("= \t", begin + 1);
        if (value != std::string::npos && value + 1 < setting.size()) print_line(setting);
    }
    end_header(header.format());
    copy_data();
}

/// A picture's line of dimensions as RADIANCE writes it, with numbers of eight columns.
std::string aligned(const std::string& resolution) {
    const std::vector<std::string> words = split_words(resolution);
    if (words.size() != 4) return resolution;
    return formatted("%s %8s %s %8s", words[0].c_str(), words[1].c_str(), words[2].c_str(), words[3].c_str());
}

/// -c: the header with the command added; the command gets the data. Reads stdin byte by byte up to there,
/// for the rest is the command's.
int run_on_data(const std::vector<std::string>& words, Dimensions dimensions) {
    std::setvbuf(stdin, nullptr, _IONBF, 0);
    const InfoHeader header = header_of_stdin();
    for (const std::string& line : header.lines)
        if (!is_format_line(line)) print_line(line);
    print_line(join_command(words));
    end_header(header.format());
    if (dimensions != Dimensions::none) {
        const auto resolution = read_dimensions(stdin);
        if (!resolution) throw Error(Location{"standard input"}, "no resolution string");
        if (dimensions == Dimensions::too) print_line(aligned(*resolution));
    }
    std::fflush(stdout);
    std::vector<char*> command;
    for (const std::string& word : words) command.push_back(const_cast<char*>(word.c_str()));
    command.push_back(nullptr);
    execvp(command[0], command.data());
    throw Error("cannot run " + words[0] + ": " + std::strerror(errno));
}

void print_header(const std::string& path, const std::vector<std::string>& lines) {
    std::printf("%s:\n\t", path.c_str());
    for (const std::string& line : lines) std::printf("%s\n\t", line.c_str());
    std::putchar('\n');
}

/// An OpenEXR picture as print_file(); its rows are RADIANCE's usual ones, from the top and from the left.
bool print_exr(const std::string& path, Dimensions dimensions) {
    ExrInfo info;
    try {
        info = read_exr_info(path);
    } catch (const Error& error) {
        std::fprintf(stderr, "getinfo: %s\n", message_line(error.what()).c_str());
        return false;
    }
    const std::string size = formatted("-Y %d +X %d", info.height, info.width);
    if (dimensions == Dimensions::only) {
        std::printf("%s: %s\n", path.c_str(), size.c_str());
        return true;
    }
    print_header(path, info.lines);
    if (dimensions == Dimensions::too) std::printf("\t%s\n", size.c_str());
    return true;
}

/// Prints one file under its name; false if it cannot be read, so that the others get their turn.
bool print_file(const std::string& path, Dimensions dimensions) {
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        const char* const why = std::strerror(errno);
        std::fprintf(stderr, "getinfo: %s: cannot open: %s\n", message_line(path).c_str(), why);
        return false;
    }
    const auto header = read_info_header(file);
    if (!header) {
        std::fclose(file);
        if (is_exr_file(path)) return print_exr(path, dimensions);
        std::fprintf(stderr, "getinfo: %s: bad header (is it a picture, octree or mesh?)\n",
                     message_line(path).c_str());
        return false;
    }
    if (dimensions == Dimensions::only) {
        std::printf("%s: %s\n", path.c_str(), dimensions_of(file).c_str());
    } else {
        print_header(path, header->lines);
        if (dimensions == Dimensions::too) std::printf("\t%s\n", dimensions_of(file).c_str());
    }
    std::fclose(file);
    return true;
}

void print_stdin(Dimensions dimensions) {
    const InfoHeader header = header_of_stdin();
    if (dimensions != Dimensions::only) {
        for (const std::string& line : header.lines) print_line(line);
        std::putchar('\n');
    }
    if (dimensions != Dimensions::none) print_line(dimensions_of(stdin));
}

/// "-": the data without the header, with -d also without the line of dimensions.
void print_data(Dimensions dimensions) {
    header_of_stdin();
    if (dimensions == Dimensions::only && !read_dimensions(stdin))
        throw Error(Location{"standard input"}, "no resolution string");
    copy_data();
}

int getinfo(int argc, char** argv) {
    GetinfoSettings settings;
    OptionTable options = getinfo_option_table(settings);
    const auto files = options.parse(argc, argv);
    if (!files) return 0;
    switch (settings.action) {
        case GetinfoSettings::Action::append:
            append_lines(settings.words);
            return 0;
        case GetinfoSettings::Action::replace:
            replace_lines(settings.words);
            return 0;
        case GetinfoSettings::Action::run:
            return run_on_data(settings.words, settings.dimensions);
        case GetinfoSettings::Action::print:
            break;
    }
    if (files->empty()) {
        print_stdin(settings.dimensions);
        return 0;
    }
    if (*files == std::vector<std::string>{"-"}) {
        print_data(settings.dimensions);
        return 0;
    }
    bool all = true;
    for (const std::string& path : *files) all = print_file(path, settings.dimensions) && all;
    return all ? 0 : 1;
}

}  // namespace
}  // namespace infra

int main(int argc, char** argv) { return infra::run_program("getinfo", infra::getinfo, argc, argv); }
