// Spectral pictures: RADIANCE's format and OpenEXR, there and back.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "common/pictures/picture.h"
#include "common/pictures/spectral_exr.h"
#include "common/pictures/spectral_header.h"
#include "test_files.h"

namespace infra {
namespace {

using test::TemporaryFolder;
using test::write_file;

/// Values over five decades, different in every channel.
Picture spectral_picture(int width, int height, const Channels& bands) {
    Picture picture{.width = width, .height = height, .channels = bands.count()};
    picture.space = ColorSpace::spectrum;
    picture.bands = bands;
    for (int i = 0; i < width * height * bands.count(); ++i)
        picture.pixels.push_back(0.01f * static_cast<float>(1 + (i * 7919) % 100003));
    picture.header.lines = {"oconv a.rad", "VIEW= -vtv -vp 0 0 0"};
    return picture;
}

TEST(SpectralPicture, OpenExrKeepsEveryBit) {
    const TemporaryFolder folder;
    for (const Channels& bands : {Channels::spectral(3, 8000, 12000), Channels::spectral(11, 300, 2500),
                                  Channels::spectral(24, 3000, 5000)}) {
        const Picture picture = spectral_picture(9, 5, bands);
        write_exr(folder / "p.exr", picture, {});
        const Picture read = read_picture(folder / "p.exr");
        EXPECT_EQ(read.bands, bands);
        EXPECT_EQ(read.space, ColorSpace::spectrum);
        ASSERT_EQ(read.channels, bands.count());
        EXPECT_EQ(read.pixels, picture.pixels);
        EXPECT_EQ(channels_of(read.header, read.channels), bands);
    }
}

TEST(SpectralPicture, OpenExrDescribesItsChannels) {
    const TemporaryFolder folder;
    write_exr(folder / "p.exr", spectral_picture(4, 4, Channels::spectral(4, 8000, 12000)),
              {.unit = "W.m-2.sr-1", .band = "8-12 um"});
    const auto input = OIIO::ImageInput::open(folder / "p.exr");
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<std::string> names = spec.channelnames;
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"S0.10500,000nm", "S0.11500,000nm", "S0.8500,000nm",
                                               "S0.9500,000nm"}));
    EXPECT_EQ(spec.get_string_attribute("bandLimits"), "12000 11000 10000 9000 8000");
    EXPECT_EQ(spec.get_string_attribute("spectralLayoutVersion"), "1.0");
    EXPECT_EQ(spec.get_string_attribute("emissiveUnits"), "W.m^-2.sr^-1");
    EXPECT_NE(spec.get_string_attribute("channelValues"), "");
}

TEST(SpectralPicture, OthersChannelNamesAreUnderstood) {
    const auto channels = spectral_channels(
        {"B", "G", "R", "S0.10,5um", "S0.8500,000nm", "S0.9,5E3nm", "S1.9500,000nm", "S0.x", "T.500,0nm"});
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].index, 3u);
    EXPECT_DOUBLE_EQ(channels[0].nm, 10500);
    EXPECT_EQ(channels[1].index, 5u);
    EXPECT_EQ(channels[2].index, 4u);
    EXPECT_EQ(bands_around(channels), Channels::spectral(3, 8000, 11000));
    EXPECT_FALSE(bands_around({{0, 700}, {1, 600}, {2, 400}}));
    EXPECT_FALSE(bands_around({{0, 700}, {1, 600}}));
    EXPECT_EQ(spectral_channel_name(8250.5), "S0.8250,500nm");
}

TEST(SpectralPicture, RadianceFormatKeepsItsPrecision) {
    const TemporaryFolder folder;
    for (const Channels& bands : {Channels::spectral(3, 8000, 12000), Channels::spectral(8, 380, 780),
                                  Channels::spectral(24, 3000, 5000)}) {
        const Picture picture = spectral_picture(30, 4, bands);  // wide enough for run lengths
        write_hdr(folder / "p.hsr", picture);
        const Picture read = read_picture(folder / "p.hsr");
        EXPECT_EQ(read.bands, bands);
        ASSERT_EQ(read.pixels.size(), picture.pixels.size());
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 30; ++x) {
                const auto before = picture.at(x, y), after = read.at(x, y);
                const float step =
                    *std::ranges::max_element(before) / 128;  // of the common exponent, at most
                for (int c = 0; c < bands.count(); ++c) EXPECT_NEAR(after[c], before[c], 0.51f * step);
            }
        }
    }
}

TEST(SpectralPicture, ReadsAndWritesWhatRadianceWrites) {
    const TemporaryFolder folder;
    // rtrace -fac -x 2 -y 2 -cs 5 -cw 8000 12000 -co+ of RADIANCE 6.1, and its -faf for the same rays.
    const std::string header =
        "#?RADIANCE\nNCOMP=5\nWAVELENGTH_SPLITS= 12000 10666.7 9333.33 8000\nFORMAT=Radiance_spectra\n\n"
        "-Y        2 +X        2\n";
    const unsigned char pixels[] = {7, 20, 94, 80, 187, 131, 6, 19, 90, 77, 180, 126,
                                    0, 0,  0,  0,  0,   0,   6, 19, 90, 77, 180, 126};
    const float values[] = {0.225f,  0.625f,   2.95f,    2.51f,   5.86f,   0.00675f, 0.01875f,
                            0.0885f, 0.0753f,  0.1758f,  0,       0,       0,        0,
                            0,       0.00675f, 0.01875f, 0.0885f, 0.0753f, 0.1758f};
    write_file(folder / "r.hsr", header + std::string(pixels, pixels + sizeof pixels));
    const Picture read = read_picture(folder / "r.hsr");
    EXPECT_EQ(read.bands, Channels::spectral(5, 8000, 12000));
    ASSERT_EQ(read.pixels.size(), std::size(values));
    for (std::size_t i = 0; i < std::size(values); ++i)
        EXPECT_NEAR(read.pixels[i], values[i], (i < 5 ? 8.0f : 0.25f) / 512) << i;

    Picture ours{.width = 2, .height = 2, .channels = 5};
    ours.pixels.assign(std::begin(values), std::end(values));
    ours.bands = read.bands;
    write_hdr(folder / "o.hsr", ours);
    std::ifstream file(folder / "o.hsr", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    EXPECT_TRUE(bytes.ends_with(std::string(pixels, pixels + sizeof pixels)));
}

TEST(SpectralPicture, WithoutUsableWavelengthsHasNoBands) {
    PictureHeader header;
    EXPECT_FALSE(channels_of(header, 5));
    header.lines = {"WAVELENGTH_SPLITS= 780 588 480"};
    EXPECT_FALSE(channels_of(header, 5));
    header.lines = {"WAVELENGTH_SPLITS= 780 588 480 780"};
    EXPECT_FALSE(channels_of(header, 5));
    header.lines = {"WAVELENGTH_SPLITS= 780 588 480 380"};
    EXPECT_FALSE(channels_of(header, 100));
    EXPECT_EQ(channels_of(header, 5), Channels::spectral(5, 380, 780));
    set_channel_lines(header, Channels());
    EXPECT_TRUE(header.lines.empty());
}

}  // namespace
}  // namespace infra
