// Which numbers of a spectrum are written: the options -pRGB, -pXYZ, -pc, -pY, -pS, -pM, -pA and -co.
#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "common/spectra/channels.h"
#include "common/spectra/color_primaries.h"

namespace infra {

struct OutputColor {
    enum class Kind { rgb, xyz, primaries, photopic, scotopic, melanopic, average, spectrum };
    Kind kind = Kind::rgb;
    Primaries primaries = radiance_primaries();  ///< -pc

    /// Whether one number is written, not three or one a channel.
    bool is_single() const { return kind >= Kind::photopic && kind <= Kind::average; }
};

/// Adds -pRGB, -pXYZ and -pc. `color` must outlive the table, here and below.
void add_primaries_rows(OptionTable& table, OutputColor& color);
/// Adds -pY, -pS, -pM and -pA.
void add_response_rows(OptionTable& table, OutputColor& color);
/// Adds -co; listed in -defaults when there are more than three channels and something else is not asked for.
OptionRow& add_spectrum_row(OptionTable& table, OutputColor& color, const int& channel_count);

/// What is written for these channels: RGB channels have no spectrum but themselves.
OutputColor for_channels(OutputColor color, const Channels& channels);

/// What is wrong with writing colours of a range that the eye does not see; empty when nothing is.
std::string color_warning(const OutputColor& color, const Channels& channels);

/// "32-bit_rle_rgbe", "32-bit_rle_xyze" or "Radiance_spectra": what pixels of a common exponent hold.
const char* pixel_format(const OutputColor& color);

/// Header lines that tell what the numbers are; none for RADIANCE's RGB and for single numbers.
std::vector<std::string> color_header_lines(const OutputColor& color, const Channels& channels);

}  // namespace infra
