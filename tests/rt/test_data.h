// Data files and pictures for scenes with brightdata, specpict and their kin. All values lie within 0..1.
#pragma once

#include <string>

#include "common/pictures/picture.h"
#include "common/test_files.h"

namespace infra::test {

struct DataFiles {
    std::string map;               ///< over x 0..1 and y 0, .5, 2: .1 + .4 x + .25 y
    std::string spectrum;          ///< .2 at 380 nm to .6 at 780 nm
    std::string spectra;           ///< over x and y 0..1 and 5 wavelengths 380..780 nm
    std::string picture;           ///< 3 x 2 pixels; red is u/4, green v/2, blue .25
    std::string spectral_picture;  ///< 2 x 2 pixels, 4 bands of 380..780 nm: 32.5/64 to 56.5/64
};

inline DataFiles write_data(const TemporaryFolder& folder) {
    const DataFiles files{folder / "map.dat", folder / "spectrum.dat", folder / "spectra.dat",
                          folder / "picture.exr", folder / "picture.hsr"};
    write_file(files.map, "2  0 1 2  0 0 3 0 .5 2\n .1 .225 .6  .5 .625 1\n");
    write_file(files.spectrum, "1  380 780 3  .2 .4 .6\n");
    write_file(
        files.spectra,
        "3  0 1 2  0 1 2  380 780 5\n .1 .2 .3 .4 .5  .5 .5 .5 .5 .5\n .3 .3 .4 .3 .3  .9 .8 .7 .6 .5\n");

    Picture picture{.width = 3, .height = 2};
    for (const float v : {1.0f, 0.0f})
        for (const float u : {0.0f, 0.75f, 1.5f})
            for (const float value : {u / 4, v / 2, 0.25f}) picture.pixels.push_back(value);
    write_exr(files.picture, picture, {});

    std::string bytes =
        "#?RADIANCE\nNCOMP=4\nWAVELENGTH_SPLITS= 780 588 480 380\nFORMAT=Radiance_spectra\n\n-Y 2 +X 2\n";
    for (int pixel = 0; pixel < 4; ++pixel)
        for (const int byte : {32, 40, 48, 56, 130}) bytes += static_cast<char>(byte);
    write_file(files.spectral_picture, bytes);
    return files;
}

}  // namespace infra::test
