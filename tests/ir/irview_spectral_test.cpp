// irview on spectral pictures: the whole range by default, single bands by number or wavelength.
#include <gtest/gtest.h>

#include <sstream>

#include "common/pictures/picture.h"
#include "common/planck/planck.h"
#include "programs/command.h"

namespace infra::ir {
namespace {

using test::Folder;
using test::Outcome;
using test::run;

constexpr int bands_count = 8;

/// Black surfaces from 280 K on, 10 K a column, in 8 bands of 8..12 um.
Picture warm_picture() {
    const Channels bands = Channels::spectral(bands_count, 8000, 12000);
    Picture picture{.width = 4, .height = 2, .channels = bands_count};
    picture.space = ColorSpace::spectrum;
    picture.bands = bands;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < bands_count; ++c)
                picture.pixels.push_back(
                    static_cast<float>(bands_count * band_radiance(280 + 10 * x, bands.lower_nm(c) / 1000,
                                                                   bands.upper_nm(c) / 1000)));
    return picture;
}

class IrviewSpectral : public testing::Test {
  protected:
    void SetUp() override {
        write_exr(folder_.path("p.exr"), warm_picture(), {.quantity = "radiance", .unit = "W.m-2.sr-1"});
        write_hdr(folder_.path("p.hsr"), warm_picture());
    }

    /// The values that irview writes.
    Picture shown(const std::string& options, const std::string& picture = "p.exr") {
        const Outcome outcome = run(folder_, "irview " + options + " -o t.exr " + picture);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read_picture(folder_.path("t.exr"));
    }

    Folder folder_;
};

TEST_F(IrviewSpectral, ShowsTheRadianceOfTheWholeRange) {
    const Picture picture = shown("");
    ASSERT_EQ(picture.channels, 1);
    for (int x = 0; x < 4; ++x) EXPECT_NEAR(picture.at(x, 1)[0], band_radiance(280 + 10 * x, 8, 12), 1e-4);
    EXPECT_EQ(picture.header.value("BAND"), "8-12 um");
    EXPECT_FALSE(picture.header.value("NCOMP"));
}

TEST_F(IrviewSpectral, ShowsTheRadianceOfAChannel) {
    for (const char* choice : {"-c 0", "-wl 12"}) {
        const Picture picture = shown(choice);
        EXPECT_NEAR(picture.at(2, 0)[0], band_radiance(300, 11.5, 12), 1e-5) << choice;
        EXPECT_EQ(picture.header.value("BAND"), "11.5-12 um");
    }
}

TEST_F(IrviewSpectral, KnowsTheBandForTemperatures) {
    for (const char* choice : {"-K", "-K -c 3", "-K -wl 8.1"}) {
        const Picture picture = shown(choice);
        for (int x = 0; x < 4; ++x) EXPECT_NEAR(picture.at(x, 1)[0], 280 + 10 * x, 1e-3) << choice;
    }
    EXPECT_NEAR(shown("-K", "p.hsr").at(1, 1)[0], 290, 0.3);
}

TEST_F(IrviewSpectral, PrintsEveryBand) {
    const Outcome outcome = run(folder_, "irview -C -stats -region 1 0 2 1 pixel p.exr");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(
        outcome.out.starts_with("# apparent temperature, degC, 8-12 um\n# channel all: 8-12 um\n"
                                "# channel 0: 11.5-12 um\n"))
        << outcome.out;
    EXPECT_NE(outcome.out.find("\npixel\tall\t1\t16.85"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\npixel\t7\t1\t16.85"), std::string::npos) << outcome.out;
    const Outcome one = run(folder_, "irview -stats -wl 8.2 p.exr");
    EXPECT_NE(one.out.find("# channel 7: 8-8.5 um\n"), std::string::npos) << one.out;
}

// A band stands for the whole range: channels keep their own.
TEST_F(IrviewSpectral, AChannelHasItsOwnBand) {
    folder_.write("flat", "8 1\n12 1\n");
    for (const std::string scale : {"-band 8 12", "-response flat"}) {
        EXPECT_NEAR(shown("-K " + scale).at(2, 0)[0], 300, 1e-3) << scale;
        const Outcome outcome = run(folder_, "irview -K " + scale + " -stats -region 2 0 3 1 pixel p.exr");
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        std::istringstream lines(outcome.out);
        int rows = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with('#')) continue;
            std::istringstream words(line);
            std::string region, name, pixels;
            double mean = 0;
            words >> region >> name >> pixels >> mean;
            EXPECT_NEAR(mean, 300, 1e-3) << line;
            ++rows;
        }
        EXPECT_EQ(rows, 1 + bands_count);
        for (const std::string channel : {" -c 3", " -wl 8.1"})
            EXPECT_EQ(run(folder_, "irview -K " + scale + channel + " -stats p.exr").err,
                      "irview: -band and -response are for the whole range of a spectral picture (a channel "
                      "has its own band: leave them out)\n");
    }
}

TEST_F(IrviewSpectral, RefusesWavelengthsThatAreNotThere) {
    write_exr(folder_.path("rgb.exr"), {.width = 1, .height = 1, .channels = 3, .pixels = {1, 2, 3}}, {});
    EXPECT_EQ(run(folder_, "irview -stats -wl 3 p.exr").err,
              "irview: the picture has no channel at 3 um (-wl is in um; the picture's range is 8-12 um)\n");
    EXPECT_EQ(run(folder_, "irview -stats -wl 3 rgb.exr").err,
              "irview: the picture tells no wavelengths of its channels\n");
    EXPECT_EQ(run(folder_, "irview -stats -wl 9 -c 1 p.exr").err,
              "irview: -c and -wl both choose a channel (give one of them)\n");
}

}  // namespace
}  // namespace infra::ir
