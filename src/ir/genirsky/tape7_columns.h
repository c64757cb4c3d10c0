// The headings of a tape7 and the fields under them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"

namespace infra::ir {

/// A column of fixed width: characters begin .. end - 1 of a line, counted from 0.
struct Tape7Column {
    std::string heading;  ///< with "_" for blanks within
    std::size_t begin = 0, end = 0;
};

class Tape7Columns {
  public:
    /// Whether a line holds headings: its first word is FREQ or a wavelength.
    static bool are_headings(std::string_view line);

    /// throws Error for headings of modes that are not read.
    Tape7Columns(std::string_view line, Location where);

    int line() const { return where_.line; }
    bool has_radiance() const { return has_radiance_; }

    const Tape7Column& frequency() const { return column("FREQ"); }
    const Tape7Column& transmittance() const { return column(has_radiance_ ? "TOT_TRANS" : "COMBIN"); }
    /// throws Error when there is no such heading.
    const Tape7Column& column(std::string_view heading) const;

  private:
    Location where_;
    std::vector<Tape7Column> columns_;
    bool has_radiance_ = false;
};

/// The number in a field, or nothing where the field is blank.
/// throws Error for anything else and for a field that the end of the line cuts
std::optional<double> tape7_field(std::string_view line, const Tape7Column& column, const Location& where);

}  // namespace infra::ir
