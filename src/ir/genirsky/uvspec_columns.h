// Lines of columns as `output_user` makes them.
#pragma once

#include "ir/genirsky/uvspec.h"

namespace infra::ir {

class UvspecColumns {
  public:
    /// throws Error for a layout without abscissa, with one twice, or with uu and no umu.
    explicit UvspecColumns(const UvspecLayout& layout);

    bool has(std::string_view name) const;
    /// Throws Error unless the line has a number for every column.
    void check(const NumberLine& line, const NumberText& text) const;
    SpectralAxis axis() const;
    /// Of the line along axis(), cm^-1 or um. throws Error unless it is above 0
    double place(const NumberLine& line, const NumberText& text) const;
    /// The first number of a column.
    const PlacedNumber& first(const NumberLine& line, std::string_view name) const;

  private:
    std::size_t index(std::string_view name) const;

    std::vector<std::string> names_;
    std::size_t directions_;  ///< numbers that uu stands for
};

}  // namespace infra::ir
