#include "rt/programs/view_sequence.h"

#include <vector>

#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"

namespace infra {
namespace {

constexpr std::size_t longest_line = 1 << 16;

}  // namespace

bool ViewSequence::read_line(std::string& line) {
    line.clear();
    int c;
    while ((c = std::getc(input_)) != EOF && c != '\n') {
        line += static_cast<char>(c);
        if (line.size() > longest_line) throw Error(Location{name_, line_number_ + 1}, "line does not end");
    }
    throw_if_interrupted();  // which ends reading too
    ++line_number_;
    return c != EOF || !line.empty();
}

/// Options in order; -vf is one more than parse_view knows.
void ViewSequence::change_view(const std::string& line) {
    const std::vector<std::string> words = split_words(line);
    int options = 0;
    std::string part;
    const auto apply_part = [&] {
        if (const std::string bad = bad_view_word(part); !bad.empty())
            throw Error("bad view option '" + bad + "'", "it is misspelt, or numbers are missing after it");
        options += parse_view(part, view_);
        part.clear();
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] != "-vf") {
            part += words[i] + " ";
            continue;
        }
        apply_part();
        if (++i == words.size()) throw Error("-vf without a file");
        read_view_file(words[i], view_);
        ++options;
    }
    apply_part();
    if (options == 0) throw Error("no view option in this line", "such as VIEW= -vp 0 0 0 -vd 0 1 0");
    set_up_view(view_);
}

bool ViewSequence::next() {
    for (std::string line; read_line(line);) {
        if (line.starts_with("-v"))
            throw Error(Location{name_, line_number_}, "not a view line", "start it with VIEW=");
        if (!is_view_line(line)) continue;
        const View before = view_;
        try {
            change_view(line);
        } catch (const Error& error) {
            throw Error(Location{name_, line_number_}, error.what());
        }
        previous_ = before;
        return true;
    }
    return false;
}

}  // namespace infra
