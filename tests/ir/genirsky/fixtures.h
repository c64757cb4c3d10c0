// Files of atmosphere codes in their documented layouts, with numbers from closed forms: grey air of one
// temperature, whose transmittance is the same at all wavenumbers and whose radiance is (1 - it) times
// Planck's law.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/format.h"
#include "common/test_files.h"
#include "ir/genirsky/sampled_spectrum.h"

namespace infra::ir::test {

using infra::test::error_of;

struct GreyAir {
    double temperature = 288.15;  ///< K
    double transmittance = 0.6;
    double background = 0;  ///< K of a black surface behind it; 0: none

    /// W m^-2 sr^-1/cm^-1
    double path(double wavenumber) const {
        return (1 - transmittance) * wavenumber_radiance(temperature, wavenumber);
    }
    double surface(double wavenumber) const {
        return background > 0 ? transmittance * wavenumber_radiance(background, wavenumber) : 0;
    }
};

struct Tape7Layout {
    int version = 5;     ///< of MODTRAN: 4 writes blanks within headings and fewer columns
    bool solar = false;  ///< IEMSCT 2: no blank fields
    double first = 700, last = 1400, step = 2;  ///< cm^-1
};

/// The cards, as far as they matter: only their presence does.
inline std::string tape7_cards(int mode) {
    return formatted("M   2    3    %d    0    0    0    0    0    0    0    0    0    0    .000 .000\n",
                     mode) +
           "F   0F   0   365.000\n"
           "    1    0    0    0    0    0    23.000      .000      .000      .000      .000\n"
           "      .000   100.000    30.000      .000      .000      .000    0          .000\n"
           "   700.000  1400.000     2.000     4.000\n";
}

inline std::string tape7_headings(int version) {
    return version == 4
               ? "    FREQ  TOT TRANS  PTH THRML  THRML SCT  SURF EMIS   SOL SCAT  SING SCAT  GRND RFLT"
                 "  DRCT RFLT  TOTAL RAD  REF SOL  SOL@OBS   DEPTH\n"
               : "    FREQ  TOT_TRANS  PTH_THRML  THRML_SCT  SURF_EMIS   SOL_SCAT  SING_SCAT  GRND_RFLT"
                 "  DRCT_RFLT  TOTAL_RAD  REF_SOL  SOL@OBS   DEPTH DIR_EM    TOA_SUN BBODY_T[K]\n";
}

/// One line of data; radiances are written per cm^2.
inline std::string tape7_row(const GreyAir& air, double wavenumber, const Tape7Layout& layout) {
    constexpr double per_cm2 = 1e-4;
    const std::string blank(11, ' '), sun = layout.solar ? formatted("%11.4E", 0.) : blank;
    const double path = per_cm2 * air.path(wavenumber), surface = per_cm2 * air.surface(wavenumber);
    std::string row =
        formatted("%8.2f%11.8f%11.4E%11.4E%11.4E", wavenumber, air.transmittance, path, 0., surface);
    row += sun + sun + formatted("%11.4E", 0.) + sun + formatted("%11.4E", path + surface);
    row += layout.solar ? formatted("%9.2E%9.2E", 0., 0.) : std::string(18, ' ');
    row += formatted("%8.3f", -std::log(air.transmittance));
    if (layout.version == 5)
        row += formatted("%7.4f", 1.) + (layout.solar ? formatted("%11.3E", 0.) : blank) +
               formatted("%11.3f", 280.);
    return row + "\n";
}

inline std::string tape7_run(const GreyAir& air, const Tape7Layout& layout = {}) {
    std::string text = tape7_cards(layout.solar ? 2 : 1) + tape7_headings(layout.version);
    for (double wavenumber = layout.first; wavenumber <= layout.last; wavenumber += layout.step)
        text += tape7_row(air, wavenumber, layout);
    return text + " -9999.\n";
}

/// A run of transmittances alone, mode 0: headings of two lines.
inline std::string tape7_transmittance_run(double transmittance) {
    std::string text = tape7_cards(0) +
                       "    FREQ COMBIN    H2O   UMIX     O3  TRACE\n"
                       "    CM-1  TRANS  TRANS  TRANS  TRANS  TRANS\n";
    for (double wavenumber = 700; wavenumber <= 3400; wavenumber += 10)
        text += formatted("%8.2f%7.4f%7.4f%7.4f%7.4f%7.4f\n", wavenumber, transmittance, 1., 1., 1., 1.);
    return text + " -9999.\n";
}

}  // namespace infra::ir::test
