// The wavelengths that a BRDF table stands for.
#pragma once

#include <string>

namespace infra {

/// 0 < lo_um < hi_um.
struct WavelengthBand {
    double lo_um, hi_um;

    double width() const { return hi_um - lo_um; }
    double center() const { return 0.5 * (lo_um + hi_um); }
    bool operator==(const WavelengthBand&) const = default;

    /// "8-9 um".
    std::string text() const;
};

/// Width of what two bands have in common [um]; touching ends are nothing, nor is a share of rounding's size.
double overlap(const WavelengthBand& a, const WavelengthBand& b);

}  // namespace infra
