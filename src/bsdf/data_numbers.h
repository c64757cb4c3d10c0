// The numbers of a <ScatteringData>, separated by blanks and commas, and the braces of tensor trees.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"

namespace infra {

class DataNumbers {
  public:
    /// `text` must outlive this; `start` is where it begins.
    DataNumbers(std::string_view text, const Location& start) : text_(text), start_(start) { skip_blanks(); }

    bool at_end() const { return at_ == text_.size(); }
    /// Whether this brace comes next; if so, it is passed over.
    bool take(char brace);
    /// Whether it comes next.
    bool sees(char brace) const { return !at_end() && text_[at_] == brace; }
    /// The next number, which must be there.
    ///   throws  Error for what is no number, nan and infinity among it
    double next();
    /// The same for a BSDF: one below 0 becomes 0 and is counted.
    float next_value();

    /// Numbers below 0 so far.
    std::size_t negative_count() const { return negative_count_; }
    /// One warning about them, "file:line: ...", if there were any.
    void warn_of_negatives(std::vector<std::string>& warnings) const;

    /// At what comes next.
    Error error(std::string_view message, std::string_view hint = {}) const;

  private:
    void skip_blanks();
    Location place(std::size_t at) const;

    std::string_view text_;
    Location start_;
    std::size_t at_ = 0;
    std::size_t negative_count_ = 0;
    std::size_t first_negative_ = 0;
};

}  // namespace infra
