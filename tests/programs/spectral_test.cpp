// rtrace and rpict with more than three channels, from the outside. Expected figures follow from the scene.
#include <gtest/gtest.h>

#include "command.h"
#include "common/pictures/picture.h"
#include "common/planck/planck.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

/// Red, green and blue glow ahead, none behind: which band gets which of them is RADIANCE's rule.
constexpr const char* glow =
    "void glow shine 0 0 4 1 2 3 0\n"
    "shine source ahead 0 0 4 0 1 0 90\n";

struct Spectral : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("scene.rad", glow);
        folder.write("rays", "0 0 0 0 1 0\n");
        ASSERT_EQ(test::run(folder, "oconv scene.rad > scene.oct").status, 0);
    }
    Outcome rtrace(const std::string& options) {
        return test::run(folder, "rtrace -w " + options + " scene.oct < rays");
    }
    Outcome rpict(const std::string& options) {
        return test::run(folder, "rpict -w- -vh 20 -vv 20 -x 24 -y 24 " + options + " scene.oct");
    }
    /// Lines of the header from NCOMP on.
    static std::string header_end(const std::string& text) {
        const std::size_t start = text.find("\nNCOMP=");
        return start == text.npos ? "" : text.substr(start + 1, text.find("\n\n") - start);
    }
};

TEST_F(Spectral, rtrace_says_what_its_numbers_are) {
    EXPECT_EQ(header_end(rtrace("-cs 8").out), "NCOMP=3\nFORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-cs 8 -co+").out),
              "NCOMP=8\nWAVELENGTH_SPLITS= 780 588 480 380\nFORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-cs 8 -co+ -ovW").out),
              "NCOMP=16\nWAVELENGTH_SPLITS= 780 588 480 380\nFORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-cs 4 -cw 8000 12000 -co+ -fac").out),
              "NCOMP=4\nWAVELENGTH_SPLITS= 12000 10666.66667 9333.333333 8000\nFORMAT=Radiance_spectra\n");
    EXPECT_EQ(header_end(rtrace("-cs 8 -pXYZ").out),
              "NCOMP=3\nPRIMARIES= 1.0000 0.0000 0.0000 1.0000 0.0000 0.0000 0.3333 0.3333\n"
              "FORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-pXYZ -fac").out),
              "NCOMP=3\nPRIMARIES= 1.0000 0.0000 0.0000 1.0000 0.0000 0.0000 0.3333 0.3333\n"
              "FORMAT=32-bit_rle_xyze\n");
    EXPECT_EQ(header_end(rtrace("-pc .7 .3 .2 .7 .13 .05 .31 .33").out),
              "NCOMP=3\nPRIMARIES= 0.7000 0.3000 0.2000 0.7000 0.1300 0.0500 0.3100 0.3300\n"
              "FORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-pY").out), "NCOMP=1\nFORMAT=ascii\n");
    EXPECT_EQ(header_end(rtrace("-co+").out), "NCOMP=3\nFORMAT=ascii\n");
}

TEST_F(Spectral, rtrace_writes_bands_from_the_longest_wavelength) {
    EXPECT_EQ(rtrace("-h -cs 4 -cw 8000 12000 -co+").out,
              "1.000000e+00\t2.000000e+00\t2.000000e+00\t3.000000e+00\t\n");
    // 3/4 * 2^2 for the brightest, the exponent's bias is 128.
    EXPECT_EQ(rtrace("-h -cs 4 -cw 8000 12000 -co+ -fac").out, std::string("\x40\x80\x80\xc0\x82"));
}

TEST_F(Spectral, rtrace_warns_of_colors_that_nobody_sees) {
    const Outcome result = rtrace("-w+ -h -cs 6 -cw 8000 12000");
    EXPECT_EQ(result.out, "1.000000e+00\t2.000000e+00\t3.000000e+00\t\n");
    EXPECT_NE(result.err.find("spectral range incompatible with color output"), std::string::npos);
    EXPECT_EQ(rtrace("-w+ -h -cs 6 -cw 8000 12000 -co+").err.find("incompatible"), std::string::npos);
}

TEST_F(Spectral, rpict_writes_colors_unless_asked) {
    for (const char* options : {"-cs 8 -cw 8000 12000 > p.hdr", "-cs 8 -cw 8000 12000 -o p.hdr"}) {
        const std::string words = options;
        const std::size_t shell = words.find('>');
        const Outcome result = rpict(words.substr(0, shell));
        if (shell != words.npos) folder.write("p.hdr", result.out);
        const Picture picture = read_picture(folder.path("p.hdr"));
        EXPECT_EQ(picture.space, ColorSpace::rgb);
        ASSERT_EQ(picture.channels, 3);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(12, 12)[c], c + 1, 0.01);
        EXPECT_FALSE(picture.bands);
    }
}

TEST_F(Spectral, rpict_writes_all_bands) {
    const Channels bands = Channels::spectral(8, 8000, 12000);
    ASSERT_EQ(rpict("-cs 8 -cw 8000 12000 -o p.exr").status, 0);
    ASSERT_EQ(rpict("-cs 8 -cw 8000 12000 -o p.hsr").status, 0);
    folder.write("q.hsr", rpict("-cs 8 -cw 8000 12000 -co+").out);
    for (const char* name : {"p.exr", "p.hsr", "q.hsr"}) {
        const Picture picture = read_picture(folder.path(name));
        EXPECT_EQ(picture.bands, bands) << name;
        EXPECT_EQ(picture.space, ColorSpace::spectrum);
        ASSERT_EQ(picture.channels, 8);
        for (int c = 0; c < 8; ++c)
            EXPECT_NEAR(picture.at(3, 20)[c], 1 + bands.primary_of(c), 0.01) << name << c;
    }
    EXPECT_EQ(read_picture(folder.path("p.exr")).header.value("BAND"), "8-12 um");
}

TEST_F(Spectral, rpict_writes_tristimulus_values) {
    const Outcome result = rpict("-cs 20 -pXYZ -o p.hdr");
    ASSERT_EQ(result.status, 0) << result.err;
    const Picture picture = read_picture(folder.path("p.hdr"));
    EXPECT_EQ(picture.space, ColorSpace::xyz);
    EXPECT_NEAR(picture.at(12, 12)[1], 308.9611, 3);
    ASSERT_EQ(rpict("-cs 20 -pXYZ -o p.exr").status, 0);
    const Picture floats = read_picture(folder.path("p.exr"));
    EXPECT_EQ(floats.space, ColorSpace::xyz);
    EXPECT_NEAR(floats.at(12, 12)[1], 308.9611, 0.3);
}

TEST_F(Spectral, thermal_surfaces_have_plancks_radiance_in_every_band) {
    folder.write("scene.rad", "void thermal warm 0 0 3 300 8 12\nwarm source ahead 0 0 4 0 1 0 90\n");
    ASSERT_EQ(test::run(folder, "oconv scene.rad > scene.oct").status, 0);
    ASSERT_EQ(rpict("-cs 5 -cw 8000 12000 -o p.exr").status, 0);
    const Picture picture = read_picture(folder.path("p.exr"));
    double mean = 0;
    for (int c = 0; c < 5; ++c) {
        const double in_band =
            band_radiance(300, picture.bands->lower_nm(c) / 1000, picture.bands->upper_nm(c) / 1000);
        EXPECT_NEAR(picture.at(12, 12)[c] / 5, in_band, 1e-5 * in_band) << c;
        mean += picture.at(12, 12)[c] / 5;
    }
    EXPECT_NEAR(mean, band_radiance(300, 8, 12), 1e-4);
}

TEST_F(Spectral, rpict_in_rgb_has_no_other_spectrum) {
    ASSERT_EQ(rpict("-co+ -o p.hsr").status, 0);
    const Picture picture = read_picture(folder.path("p.hsr"));
    EXPECT_EQ(picture.space, ColorSpace::rgb);
    EXPECT_FALSE(picture.bands);
}

}  // namespace
}  // namespace infra
