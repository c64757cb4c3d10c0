// Views as text: option strings, VIEW= header lines and view files.
#include <algorithm>
#include <array>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"
#include "common/views/view.h"

namespace infra {
namespace {

/// An option with one number or one vector; the other pointer is null.
struct ViewWord {
    std::string_view spelling;
    double View::*number;
    Vec3 View::*vector;
};

constexpr std::array<ViewWord, 9> view_words{{
    {"-vp", nullptr, &View::point},
    {"-vd", nullptr, &View::direction},
    {"-vu", nullptr, &View::up},
    {"-vh", &View::horizontal, nullptr},
    {"-vv", &View::vertical, nullptr},
    {"-vo", &View::fore, nullptr},
    {"-va", &View::aft, nullptr},
    {"-vs", &View::shift, nullptr},
    {"-vl", &View::lift, nullptr},
}};

/// Applies the option at words[i]; returns how many words it took, 0 when it is none.
std::size_t apply_view_word(const std::vector<std::string>& words, std::size_t i, View& view) {
    const std::string& word = words[i];
    if (word.size() == 4 && word.starts_with("-vt")) {
        const auto type = view_type_of(word[3]);
        if (type) view.type = *type;
        return type ? 1 : 0;
    }
    const auto row = std::ranges::find(view_words, word, &ViewWord::spelling);
    if (row == view_words.end()) return 0;
    const std::size_t count = row->vector ? 3 : 1;
    Vec3 values{};
    for (std::size_t k = 0; k < count; ++k)
        if (i + 1 + k >= words.size() || !parse_real(words[i + 1 + k], values[int(k)])) return 0;
    if (row->vector)
        view.*row->vector = values;
    else
        view.*row->number = values.x;
    if (row->vector == &View::direction) view.distance = 1;  // the new vector's length sets it anew
    return count + 1;
}

}  // namespace

std::string format_view(const View& view) {
    const Vec3 aim = view.direction * view.distance;
    std::string text = formatted(" -vt%c", static_cast<char>(view.type));
    text += formatted(" -vp %.7g %.7g %.7g", view.point.x, view.point.y, view.point.z);
    text += formatted(" -vd %.7g %.7g %.7g", aim.x, aim.y, aim.z);
    text += formatted(" -vu %.5g %.5g %.5g", view.up.x, view.up.y, view.up.z);
    text += formatted(" -vh %.5g -vv %.5g", view.horizontal, view.vertical);
    text += formatted(" -vo %.5g -va %.5g", view.fore, view.aft);
    text += formatted(" -vs %.5g -vl %.5g", view.shift, view.lift);
    return text;
}

int parse_view(std::string_view text, View& view) {
    const std::vector<std::string> words = split_words(text);
    int count = 0;
    for (std::size_t i = 0; i < words.size();) {
        const std::size_t taken = apply_view_word(words, i, view);
        count += taken > 0;
        i += std::max<std::size_t>(taken, 1);
    }
    return count;
}

std::string bad_view_word(std::string_view text) {
    const std::vector<std::string> words = split_words(text);
    View view;
    for (std::size_t i = 0; i < words.size();) {
        const std::size_t taken = apply_view_word(words, i, view);
        if (taken == 0 && words[i].size() > 2 && words[i].starts_with("-v")) return words[i];
        i += std::max<std::size_t>(taken, 1);
    }
    return {};
}

bool is_view_line(std::string_view line) {
    std::string_view word = line.substr(0, line.find_first_of(" \t\r\n"));
    if (const std::size_t slash = word.rfind('/'); slash != std::string_view::npos)
        word.remove_prefix(slash + 1);
    for (const std::string_view start : {"VIEW=", "rpict", "rvu", "rpiece", "rxpiece", "pinterp", "rview"})
        if (word.starts_with(start)) return true;
    return false;
}

void read_view_file(const std::string& path, View& view) {
    const std::string text = read_text_file(path);
    std::string_view rest = text;
    int found = 0;
    while (!rest.empty() && rest[0] != '\n') {  // an empty line ends a picture's header
        const std::string_view line = take_line(rest);
        if (is_view_line(line)) found += parse_view(line, view);
    }
    if (found == 0)
        throw Error(Location{path}, "bad view file", "it has no line such as \"VIEW= -vp 0 0 0 -vd 0 1 0\"");
}

}  // namespace infra
