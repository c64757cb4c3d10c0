// What vwrays's command line says, and the raster of pixels that it amounts to.
#pragma once

#include <optional>
#include <string>

#include "common/options.h"
#include "common/pictures/scan_order.h"
#include "common/views/view.h"
#include "rt/programs/value_writer.h"

namespace infra {

struct VwraysSettings {
    View view;                                     ///< set up
    ScanOrder order{.width = 512, .height = 512};  ///< of the pixels
    std::string depth_file;                        ///< distances of the picture's pixels; empty: none
    NumberFormat format = NumberFormat::text;      ///< -f
    double pixel_aspect = 1;                       ///< -pa: height of a pixel over its width, 0: any
    double pixel_jitter = 0;                       ///< -pj: share of a pixel over which its rays are spread
    double lens_diameter = 0;                      ///< -pd, scene units
    int repeats = 1;                               ///< -c: rays a pixel
    bool pixels_from_input = false;                ///< -i
    bool unbuffered = false;                       ///< -u
    bool only_dimensions = false;                  ///< -d
};

/// The table refers to `settings`, which must outlive it.
OptionTable vwrays_option_table(VwraysSettings& settings);

/// Reads the command line. Nothing if -defaults, -help or -version was answered.
///   throws  Error for a bad option, view or picture
std::optional<VwraysSettings> read_vwrays_settings(int argc, char** argv);

}  // namespace infra
