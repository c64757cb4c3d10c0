#include "nrlbrdf/wavelength_band.h"

#include <algorithm>

#include "common/format.h"

namespace infra {

std::string WavelengthBand::text() const { return formatted("%g-%g um", lo_um, hi_um); }

double overlap(const WavelengthBand& a, const WavelengthBand& b) {
    constexpr double rounding = 1e-9;  // of limits computed from nanometres
    const double common = std::min(a.hi_um, b.hi_um) - std::max(a.lo_um, b.lo_um);
    return common > rounding * std::min(a.width(), b.width()) ? common : 0;
}

}  // namespace infra
