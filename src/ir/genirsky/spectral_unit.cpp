#include "ir/genirsky/spectral_unit.h"

#include <array>

#include "common/error.h"

namespace infra::ir {
namespace {

struct Row {
    std::string_view name;
    double factor;
    SpectralAxis density;
};

constexpr std::array<Row, 6> rows{{{"W/m2/sr/nm", 1e3, SpectralAxis::wavelength},
                                   {"mW/m2/sr/nm", 1, SpectralAxis::wavelength},
                                   {"W/m2/sr/um", 1, SpectralAxis::wavelength},
                                   {"W/m2/sr/cm-1", 1, SpectralAxis::wavenumber},
                                   {"mW/m2/sr/cm-1", 1e-3, SpectralAxis::wavenumber},
                                   {"W/cm2/sr/cm-1", 1e4, SpectralAxis::wavenumber}}};

}  // namespace

SpectralUnit SpectralUnit::parse(std::string_view text) {
    for (const Row& row : rows)
        if (row.name == text) return {row.name, row.factor, row.density};
    throw Error("unknown unit \"" + std::string(text) + "\"", choices());
}

std::string SpectralUnit::choices() {
    std::string text;
    for (const Row& row : rows) text += (text.empty() ? "" : ", ") + std::string(row.name);
    return text;
}

}  // namespace infra::ir
