// The text of a .brdf file as numbers: directives, comments and places apart from what the numbers mean.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace infra {

/// Reads the text from front to back, so that counts are checked before anything is allocated for them.
class TableText {
  public:
    /// `text` must outlive this; `name` stands for the file in errors. Reads the directives.
    TableText(std::string_view text, std::string name);

    /// True when rows cover 0..180 deg (`#% phi 180`).
    bool half_phi() const { return half_phi_; }

    /// True when the mirror direction is phi = 0 (`#% mirror 0`).
    bool mirror_at_zero() const { return mirror_at_zero_; }

    /// The next number; false at the end.
    ///   throws  infra::Error for what is no number, or a directive after the first number; nan and inf pass
    bool next(double& number);

    /// Line of the number that next() gave last, also once it has met the end; 1 before the first.
    int line() const { return number_line_; }

    /// Line of the n-th number of the text, from 0. Scans from the start: for messages.
    int line_of(std::size_t n) const;

    const std::string& name() const { return name_; }

  private:
    void skip_blanks_and_comments();
    void read_directive(std::string_view line);

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    int line_ = 1;
    int number_line_ = 1;
    bool number_seen_ = false;
    bool half_phi_ = false;
    bool mirror_at_zero_ = false;
};

}  // namespace infra
