// MODTRAN's tape7: spectra of the runs of one calculation, in columns of fixed width.
//
// Headings stand over the ends of their columns, so that a field reaches from the end of the heading before
// it to the end of its own; in MODTRAN 4 and 5
//
//     FREQ F8.2, TOT TRANS F11.8, PTH THRML, THRML SCT, SURF EMIS, SOL SCAT, SING SCAT, GRND RFLT, DRCT RFLT,
//     TOTAL RAD 1PE11.4 each, REF SOL, SOL@OBS 1PE9.2, DEPTH F8.3 and, in 5, three columns more
//
// with "_" for the blank within a heading in 5. A field is blank where a mode does not compute it. What
// stands before the headings echoes the input cards and is not read; a line -9999. ends a run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/genirsky/sampled_spectrum.h"

namespace infra::ir {

/// A run of one line of sight. Radiances in W m^-2 sr^-1/cm^-1; the file's are per cm^2.
struct Tape7Run {
    int line = 0;                    ///< of its headings in the file
    SampledSpectrum transmittance;   ///< 0..1
    bool has_radiance = false;       ///< modes IEMSCT 1 and 2; not in mode 0, transmittance alone
    SampledSpectrum path_radiance;   ///< PTH THRML + SOL SCAT: what the path itself sends
    SampledSpectrum total_radiance;  ///< TOTAL RAD: that and what lies behind the path

    /// Throws Error when the run is one of transmittances alone.
    void require_radiance() const;
};

/// throws Error with line and column for files without headings or data, other modes, several lines of sight
///   in one run, columns missing, blank, cut off or not numbers, frequencies that don't increase,
///   transmittances outside 0..1, negative radiances and a run without its end
std::vector<Tape7Run> parse_tape7(std::string_view text, const std::string& name);
std::vector<Tape7Run> read_tape7(const std::string& path);

}  // namespace infra::ir
