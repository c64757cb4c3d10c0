// Everything that rpict's command line says.
#pragma once

#include <string>

#include "common/views/view.h"
#include "rt/programs/output_color.h"
#include "rt/programs/render_options.h"

namespace infra {

struct RpictOptions {
    RenderOptions render = rpict_defaults();
    View view;
    int width = 512;                ///< -x: pixels at most; one of the two shrinks to fit the view
    int height = 512;               ///< -y
    double pixel_aspect = 1;        ///< -pa: height over width of a pixel, 0: whatever fits
    double motion_blur = 0;         ///< -pm: share of the time between two pictures that the shutter is open
    double lens_diameter = 0;       ///< -pd: aperture, scene units
    double pixel_jitter = 0.67;     ///< -pj: share of a pixel over which its sample is spread
    int samples_per_pixel = 0;      ///< -spp: of every pixel, 0: one where -ps and -pt want it
    int sample_spacing = 4;         ///< -ps: pixels between samples where nothing changes
    double sample_contrast = 0.05;  ///< -pt: relative difference that asks for samples in between
    int report_seconds = 0;         ///< -t
    double checkpoint_seconds = 10;    ///< -ck: between writings of what is known of a picture; 0: none
    int threads = 0;                ///< -n: 0 means all cores
    OutputColor color;              ///< -p, -co
    std::string output;             ///< -o: empty means the standard output
    std::string depth_output;       ///< -z
    std::string error_output;       ///< -se
    std::string split_output;       ///< -split
    int first_number = 0;           ///< -S: of the first picture of a sequence; 0 or less: there is none
    std::string recover;            ///< -r, -ro: an unfinished picture, or with -S its number

    bool is_sequence() const { return first_number > 0; }
};

/// rpict's option table, in the order of RADIANCE's -defaults. `options` must outlive it.
OptionTable rpict_option_table(RpictOptions& options);

}  // namespace infra
