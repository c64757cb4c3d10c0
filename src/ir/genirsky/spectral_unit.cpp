#include "ir/genirsky/spectral_unit.h"

#include <array>

#include "common/error.h"

namespace infra::ir {
namespace {

struct Row {
    std::string_view name;
    double factor;
    double per_um;
};

constexpr std::array<Row, 6> rows{{{"W/m2/sr/nm", 1, 1e3},
                                   {"mW/m2/sr/nm", 1e-3, 1e3},
                                   {"W/m2/sr/um", 1, 1},
                                   {"W/m2/sr/cm-1", 1, 0},
                                   {"mW/m2/sr/cm-1", 1e-3, 0},
                                   {"W/cm2/sr/cm-1", 1e4, 0}}};

}  // namespace

SpectralUnit SpectralUnit::parse(std::string_view text) {
    for (const Row& row : rows)
        if (row.name == text) return {row.name, row.factor, row.per_um};
    throw Error("unknown unit \"" + std::string(text) + "\"", choices());
}

std::string SpectralUnit::choices() {
    std::string text;
    for (const Row& row : rows) text += (text.empty() ? "" : ", ") + std::string(row.name);
    return text;
}

double SpectralUnit::per_wavenumber(double radiance, double wavenumber) const {
    constexpr double um_cm = 1e4;
    // |d wavelength/d wavenumber| = 1e4/wavenumber^2 um per cm^-1
    const double width = per_um_ == 0 ? 1 : per_um_ * um_cm / (wavenumber * wavenumber);
    return factor_ * width * radiance;
}

}  // namespace infra::ir
