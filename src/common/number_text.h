// Texts of numbers with comments, as data files and fonts are: blanks separate, '#' comments out the rest of
// a line, and every error names the line.
#pragma once

#include <string>
#include <string_view>

#include "common/error.h"

namespace infra {

class NumberText {
  public:
    /// The text of a file called `name`; both must outlive this.
    NumberText(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    /// False when there is a further word.
    bool at_end();
    /// The next number; `what` says what it should be, for the error when there is none.
    double real(const std::string& what);
    long long integer(const std::string& what);
    /// About the number read last.
    Error error(const std::string& message, std::string_view hint = {}) const;

  private:
    void skip_blanks_and_comments();
    std::string_view next_word(const std::string& what);
    Error no_number(std::string_view word, const std::string& expected) const;

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int line_ = 1;
    int word_line_ = 1;
};

}  // namespace infra
