#include "ir/genirsky/uvspec_columns.h"

#include <algorithm>

#include "common/format.h"

namespace infra::ir {
UvspecColumns::UvspecColumns(const UvspecLayout& layout)
    : names_(layout.columns), directions_(layout.umu.size() * std::max<std::size_t>(1, layout.phi.size())) {
    const auto count = std::ranges::count_if(
        names_, [](const std::string& name) { return name == "lambda" || name == "wavenumber"; });
    if (count != 1) throw Error("-columns must name either lambda or wavenumber, once", "-columns lambda,uu");
    for (const std::string& name : names_)
        if (std::ranges::count(names_, name) > 1) throw Error("-columns names " + name + " twice");
    if (has("uu") && layout.umu.empty())
        throw Error("the directions of uu are not stated", "-umu -1,-.5,-.1 as in uvspec's input");
}

bool UvspecColumns::has(std::string_view name) const {
    return std::ranges::find(names_, name) != names_.end();
}

std::size_t UvspecColumns::index(std::string_view name) const {
    std::size_t place = 0;
    for (const std::string& column : names_) {
        if (column == name) return place;
        place += column == "uu" ? directions_ : 1;
    }
    return place;
}

void UvspecColumns::check(const NumberLine& line, const NumberText& text) const {
    const std::size_t count = index({});
    if (line.size() != count)
        throw Error(Location{text.name, line[0].line},
                    formatted("found %zu numbers where -columns makes %zu", line.size(), count));
}

SpectralAxis UvspecColumns::axis() const {
    return has("lambda") ? SpectralAxis::wavelength : SpectralAxis::wavenumber;
}

double UvspecColumns::place(const NumberLine& line, const NumberText& text) const {
    const bool by_wavelength = axis() == SpectralAxis::wavelength;
    const PlacedNumber& number = first(line, by_wavelength ? "lambda" : "wavenumber");
    if (!(number.value > 0))
        throw Error(text.place(number),
                    by_wavelength ? "a wavelength must be above 0 nm" : "a wavenumber must be above 0 cm-1");
    return by_wavelength ? number.value / nm_per_um : number.value;
}

const PlacedNumber& UvspecColumns::first(const NumberLine& line, std::string_view name) const {
    return line[index(name)];
}

}  // namespace infra::ir
