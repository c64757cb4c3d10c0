// The output of libRadtran's uvspec: radiances by wavelength and direction, as text.
//
// Without `output_user` every wavelength has a block,
//
//     lambda edir edn eup uavgdir uavgdn uavgup
//                       phi(0)  phi(1) ..         only where phi was given
//     umu(0) u0u(0)   uu(0,0) uu(0,1) ..
//     umu(1) u0u(1)   uu(1,0) uu(1,1) ..
//
// with u0u the mean over azimuth. With `output_user` there is a line a wavelength and its columns are what
// that option named; `uu` stands for all radiances, umu by umu. The file names neither columns nor units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ir/genirsky/placed_numbers.h"
#include "ir/genirsky/sampled_spectrum.h"
#include "ir/genirsky/spectral_unit.h"

namespace infra::ir {

struct UvspecLayout {
    /// Words of `output_user`; empty: blocks. "lambda" (nm) or "wavenumber" (cm^-1) must be among them; "uu",
    /// "transmittance" and "radiance" are read, others passed over.
    std::vector<std::string> columns;
    std::vector<double> umu;  ///< with columns, the values of the input file
    std::vector<double> phi;  ///< the same, degrees; may be empty
    std::optional<SpectralUnit> unit;
};

/// A spectrum in one direction.
struct UvspecRadiance {
    double umu = 0;             ///< cosine of the direction of flight's polar angle; below 0: downwelling
    std::optional<double> phi;  ///< where the sensor looks, degrees clockwise from the south; nothing: mean
    SampledSpectrum radiance;
};

/// All radiances of a file, umu by umu.
///   throws  Error with line and column for lines of a wrong form, numbers that are none, wavelengths out of
///           order (several output levels among them), negative radiances, a closing azimuth that differs and
///           a last block cut off; for a missing unit with the choices
std::vector<UvspecRadiance> parse_uvspec(const NumberText& text, const UvspecLayout& layout);

/// A path's spectra, from columns "transmittance" and "radiance".
struct PathSpectra {
    SampledSpectrum transmittance;  ///< 0..1
    SampledSpectrum radiance;
};
/// throws Error as parse_uvspec(), and for columns without these two
PathSpectra parse_path_columns(const NumberText& text, const UvspecLayout& layout);

}  // namespace infra::ir
