#include "common/number_text.h"

#include <algorithm>

#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"

namespace infra {

bool NumberText::at_end() {
    skip_blanks_and_comments();
    return at_ == text_.size();
}

double NumberText::real(const std::string& what) {
    const std::string_view word = next_word(what);
    double number = 0;
    if (!parse_real(word, number)) throw no_number(word, "expected a number");
    return number;
}

long long NumberText::integer(const std::string& what) {
    const std::string_view word = next_word(what);
    long long number = 0;
    if (!parse_int(word, number)) throw no_number(word, "expected " + what);
    return number;
}

Error NumberText::error(const std::string& message, std::string_view hint) const {
    return Error(Location{name_, word_line_}, message, hint);
}

void NumberText::skip_blanks_and_comments() {
    while (at_ < text_.size()) {
        if (text_[at_] == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (is_blank(text_[at_])) {
            line_ += text_[at_++] == '\n';
        } else {
            return;
        }
    }
}

std::string_view NumberText::next_word(const std::string& what) {
    if (at_end()) throw error("the file ends before " + what);
    word_line_ = line_;
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '#') ++at_;
    return text_.substr(start, at_ - start);
}

Error NumberText::no_number(std::string_view word, const std::string& expected) const {
    constexpr std::size_t longest = 24;
    const std::string shown = one_line(word.substr(0, longest)) + (word.size() > longest ? "..." : "");
    return error(expected + ", found \"" + shown + "\"",
                 word.find(',') != word.npos ? "numbers are separated by blanks, not commas" : "");
}

}  // namespace infra
