// Records that are rows of numbers: lines of text with columns, or binary values.
#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "cal/builtin.h"
#include "settings.h"

namespace infra::rcalc {

/// Channel numbers that no expression can spell, for what rcalc itself supplies.
enum HiddenChannel : int {
    column_count_channel = 10'000'000,
    record_number_channel,
    output_number_channel,
    first_field_channel,  ///< and up: numeric fields of the input template
};

/// The function in(n): column n, or the number of columns for n = 0.
std::span<const cal::Builtin> column_builtins();

class Columns {
  public:
    explicit Columns(const Settings& settings) : settings_(settings) {}

    /// Reads the next record; false at the end.
    bool read(std::FILE* file);

    /// Column `number` from 1 of the record; 0 beyond the last one or where there is no number.
    double value(int number);

    std::size_t count() const;

  private:
    bool read_line(std::FILE* file);
    const char* find(int number) const;
    bool separated_by_blanks() const;

    const Settings& settings_;
    std::string line_;
    std::vector<char> bytes_;
};

}  // namespace infra::rcalc
