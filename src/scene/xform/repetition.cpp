#include "scene/xform/repetition.h"

#include <algorithm>

#include "common/error.h"
#include "common/parse_number.h"
#include "common/text_file.h"

namespace infra::xform {
namespace {

using Words = std::vector<std::string>;

constexpr int deepest_nesting = 64;  // of -f within the lines of -f

void expand(const Words& words, const RepetitionSink& sink, int nesting);

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Words of one line of a -f file: quotes around a word hold blanks together, a backslash before it takes its
/// first character as it is.
Words line_words(std::string_view line) {
    Words words;
    for (std::size_t i = 0; i < line.size();) {
        if (is_space(line[i]) || line.substr(i, 2) == "\\\n") {
            i += is_space(line[i]) ? 1 : 2;
            continue;
        }
        const char quote = line[i] == '"' || line[i] == '\'' ? line[i++] : '\0';
        if (i + 1 < line.size() && line[i] == '\\') ++i;
        std::string word;
        while (i < line.size() && (quote ? line[i] != quote : !is_space(line[i]))) word += line[i++];
        i += quote != '\0';
        words.push_back(std::move(word));
    }
    return words;
}

/// Lines of a text; a backslash before a line end joins two.
Words joined_lines(std::string_view text) {
    Words lines;
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\n' || (!line.empty() && line.back() == '\\')) {
            line += text[i];
            continue;
        }
        lines.push_back(std::move(line));
        line.clear();
    }
    if (!line.empty()) lines.push_back(std::move(line));
    return lines;
}

/// Position of the word after `option`, or 0 if it is not there.
std::size_t value_of(const Words& words, const std::string& option) {
    const auto found = std::find(words.begin() + 1, words.end(), option);
    if (found == words.end()) return 0;
    return std::size_t(found - words.begin()) + 1;
}

/// Gives the command line the name -n "letter number" if it has none.
Words named(Words words, char letter, int number) {
    words.insert(words.begin() + 1, {"-n", letter + std::to_string(number)});
    return words;
}

/// A line's number goes behind the first name.
Words named_for_line(Words words, int number) {
    const std::size_t name = value_of(words, "-n");
    if (name == 0 || name >= words.size()) return named(std::move(words), 'i', number);
    words[name] += "." + std::to_string(number);
    return words;
}

/// An element's number goes behind the last name, which all names become.
Words named_for_element(Words words, int number) {
    const std::string* last = nullptr;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i - 1] == "-n") last = &words[i];
    if (!last) return named(std::move(words), 'a', number);
    const std::string name = *last + "." + std::to_string(number);
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i - 1] == "-n") words[i] = name;
    return words;
}

void for_each_line(const Words& words, std::size_t file, const RepetitionSink& sink, int nesting) {
    if (file >= words.size() || (words[file][0] == '-' && words[file] != "-"))
        throw Error("command line error at '-f'", "a file name, or - for the standard input, must follow");
    if (nesting > deepest_nesting)
        throw Error("argument files name one another " + std::to_string(deepest_nesting) + " levels deep",
                    "does \"" + words[file] + "\" name itself?");
    int number = 0;
    for (const std::string& line : joined_lines(read_text_file(words[file]))) {
        if (line.empty() || line[0] == '#') {
            sink.remark(line);
            continue;
        }
        std::string_view rest = line;
        if (rest.starts_with('!')) rest.remove_prefix(1);
        if (rest.starts_with("xform ")) rest.remove_prefix(6);
        Words call(words.begin(), words.begin() + std::ptrdiff_t(file) - 1);
        for (std::string& word : line_words(rest)) call.push_back(std::move(word));
        call.insert(call.end(), words.begin() + std::ptrdiff_t(file) + 1, words.end());
        expand(named_for_line(std::move(call), number++), sink, nesting + 1);
    }
    if (number == 0) throw Error("empty argument file \"" + words[file] + "\"");
}

void for_each_element(const Words& words, std::size_t count_at, const RepetitionSink& sink, int nesting) {
    int count = 0;
    if (count_at >= words.size() || !parse_int(words[count_at], count) || count <= 0)
        throw Error("command line error at '-a'", "a number of repetitions above 0 must follow");
    for (int i = 0; i < count; ++i) {
        Words call = words;
        call[count_at - 1] = "-i";
        call[count_at] = std::to_string(i);
        expand(named_for_element(std::move(call), i), sink, nesting);
    }
}

void expand(const Words& words, const RepetitionSink& sink, int nesting) {
    if (const std::size_t file = value_of(words, "-f"); file > 0)
        return for_each_line(words, file, sink, nesting);
    if (const std::size_t count = value_of(words, "-a"); count > 0)
        return for_each_element(words, count, sink, nesting);
    sink.call(words);
}

}  // namespace

void for_each_call(const Words& words, const RepetitionSink& sink) { expand(words, sink, 0); }

}  // namespace infra::xform
