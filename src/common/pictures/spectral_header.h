// The lines of a picture's header that say what its channels are.
#pragma once

#include <optional>
#include <string>

#include "common/spectra/channels.h"

namespace infra {

class PictureHeader;

/// "WAVELENGTH_SPLITS= 780 588 480 380": longest wavelength, the two where red, green and blue meet (thirds
/// of a range that does not show colors), shortest, in nm.
std::string wavelength_splits_line(const Channels& channels);

/// "8-12 um": the whole range as the BAND line of a picture has it; that of channel c.
std::string band_in_um(const Channels& channels);
std::string band_in_um(const Channels& channels, int c);

/// Drops the header's NCOMP and WAVELENGTH_SPLITS lines, and adds those of spectral channels.
void set_channel_lines(PictureHeader& header, const Channels& channels);

/// The channels that WAVELENGTH_SPLITS tells of a picture with `count` channels; nothing when there is no
/// such line, it makes no sense, or there are too few or too many.
std::optional<Channels> channels_of(const PictureHeader& header, int count);

}  // namespace infra
