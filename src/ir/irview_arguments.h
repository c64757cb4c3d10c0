// irview's command line.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/pictures/palette.h"
#include "common/planck/planck_scale.h"
#include "ir/apparent_temperature.h"
#include "ir/region.h"

namespace infra::ir {

struct IrviewArguments {
    std::string picture;
    std::string layer;                               ///< of an OpenEXR picture; empty: the picture itself
    std::vector<std::string> outputs;                ///< .exr: floats, otherwise PNG
    std::optional<std::pair<double, double>> range;  ///< ends of the colour scale
    std::optional<std::string> label, unit;          ///< of the legend
    Palette palette = palettes().front();            ///< colours
    int channel = -1;                                ///< negative: the mean of all
    std::optional<double> wavelength_um;             ///< that the channel's band holds
    int block = 1;                                   ///< pixels a side averaged into one
    bool print_statistics = false;                   ///< of the regions
    std::vector<Region> regions;                     ///< to mark and measure
    std::optional<TemperatureUnit> temperature;      ///< none: values as they are
    std::optional<RadianceScale> scale;              ///< none: the band that the picture names
    std::string command_line;                        ///< for headers
};

/// Nothing when -help, -defaults or -version was answered. throws Error for a bad command line.
std::optional<IrviewArguments> read_irview_arguments(int argc, char** argv);

}  // namespace infra::ir
