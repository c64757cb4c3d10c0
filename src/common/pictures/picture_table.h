// Pictures as tables, for colorpict, mixpict and specpict.
#pragma once

#include <string>

#include "common/data/data_table.h"

namespace infra {

/// A picture as a table over u, v and channel. u runs from left to right, v from bottom to top, the shorter
/// side from 0 to 1 and the other as far as its length in square pixels says; the outermost pixels lie at the
/// ends. The exposure stays in, as RADIANCE leaves it. One channel counts as three equal ones.
///   throws  Error for missing or malformed files, XYZ, spectra, and pictures of less than 2 x 2 pixels
DataTable read_color_table(const std::string& path);

/// A spectral picture over u, v and wavelength [nm, falling as the file has it]: the middles of its bands, as
/// its header's WAVELENGTH_SPLITS gives their range.
///   throws  Error as above, for wavelengths not given and for less than 4 channels
DataTable read_spectrum_table(const std::string& path);

}  // namespace infra
