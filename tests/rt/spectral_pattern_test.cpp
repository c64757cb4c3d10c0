// Patterns that say what each wavelength does: in spectral renderings of any range, and as colours in RGB.
#include <gtest/gtest.h>

#include <cmath>

#include "common/spectra/resampler.h"
#include "scene_pieces.h"
#include "test_data.h"

namespace infra {
namespace {

const Channels long_wave = Channels::spectral(4, 8000, 12000);  // bands of 1 um, the longest first

class SpectralPattern : public ::testing::Test {
  protected:
    // A plate that shines with radiance 1 behind a pattern "p", seen above a place.
    static Spectrum above(const std::string& pattern, const Channels& channels, double x = 0, double y = 0) {
        test::TracedScene scene(pattern + " p glow m 0 0 4 1 1 1 0" + test::plate, {}, channels);
        return scene.radiance({x, y, 3}, {0, 0, -1});
    }
    static void expect_channels(const Spectrum& seen, std::initializer_list<double> wanted) {
        ASSERT_EQ(seen.channels(), static_cast<int>(wanted.size()));
        int c = 0;
        for (const double value : wanted) EXPECT_NEAR(seen[c++], value, 2e-6) << "channel " << c - 1;
    }
    static std::vector<std::string> warnings(const std::string& pattern, const Channels& channels) {
        test::TracedScene scene(pattern + " p light m 0 0 3 1 1 1" + test::plate, {}, channels);
        return scene.compiled().warnings();
    }

    const test::TemporaryFolder folder_;
};

TEST_F(SpectralPattern, SpectrumCountsEachSampleForOneStep) {
    // samples at 8, 9 ... 12 um count from half a um before to half a um behind
    expect_channels(above("void spectrum p 0 0 7 8000 12000 1 2 4 8 16", long_wave), {12, 6, 3, 1.5});
    expect_channels(above("void spectrum p 0 0 7 12000 8000 16 8 4 2 1", long_wave), {12, 6, 3, 1.5});
    // nothing is known of wavelengths below 8.5 - .25 and above 9.5 + .25 um
    expect_channels(above("void spectrum p 0 0 5 8500 9500 1 1 1", long_wave), {0, 0, 0.75, 0.75});
}

TEST_F(SpectralPattern, SpecfileIsSpectrumFromAFile) {
    test::write_file(folder_ / "s.dat", "1\n8000 12000 5\n1 2 4 8 16\n");
    expect_channels(above("void specfile p 1 " + (folder_ / "s.dat") + " 0 0", long_wave), {12, 6, 3, 1.5});
}

// RADIANCE 6.1's figures for -cs 8 -cw 8000 12000.
TEST_F(SpectralPattern, SpecfileOfUnequalStepsIsReadAsRadianceReadsIt) {
    test::write_file(folder_ / "u.dat", "1\n0 0 4 8000 9000 9500 12000\n1 2 .5 3\n");
    const std::string pattern = "void specfile p 1 " + (folder_ / "u.dat") + " 0 0";
    expect_channels(above(pattern, Channels::spectral(8, 8000, 12000)),
                    {0.7142857, 0.9591836, 1.571429, 1.571429, 1.571429, 1.571429, 1.163265, 1});
    const std::vector<std::string> said = warnings(pattern, Channels::spectral(8, 8000, 12000));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("stretched, as RADIANCE does"), std::string::npos) << said[0];
}

TEST_F(SpectralPattern, SpecdataIsSpectraByPlace) {
    // with x from one spectrum to another; wavelengths in unequal steps are asked for in equal ones
    test::write_file(folder_ / "d.dat",
                     "2\n0 1 2\n0 0 5 8000 8500 10000 11000 12000\n"
                     "1 1.5 3 4 5\n2 2 2 2 2\n");
    test::write_file(folder_ / "f.cal", "above(v,nm) = if(nm-9500, v, 10*v); same(v,nm) = v;");
    const std::string data = (folder_ / "d.dat") + " " + (folder_ / "f.cal") + " Px 0 0";
    expect_channels(above("void specdata p 4 same " + data, long_wave), {4.5, 3.5, 2.5, 1.5});
    expect_channels(above("void specdata p 4 same " + data, long_wave, 0.75), {2.625, 2.375, 2.125, 1.875});
    expect_channels(above("void specdata p 4 above " + data, long_wave), {4.5, 3.5, 11.5, 15});
}

TEST_F(SpectralPattern, SpecpictIsSpectraByPixel) {
    std::string bytes =
        "#?RADIANCE\nNCOMP=4\nWAVELENGTH_SPLITS= 12000 11000 9000 8000\nFORMAT=Radiance_spectra\n\n-Y 2 +X "
        "2\n";
    for (int pixel = 0; pixel < 4; ++pixel)
        for (const int byte : {8 * pixel, 40, 48, 56, 136}) bytes += static_cast<char>(byte);
    test::write_file(folder_ / "p.hsr", bytes);
    test::write_file(folder_ / "f.cal", "scaled(v,nm) = v*nm/1000;");
    const std::string rest = (folder_ / "p.hsr") + " " + (folder_ / "f.cal") + " Px Py 0 0";
    // the pixels: 0 and 8 above, 16 and 24 below
    expect_channels(above("void specpict p 5 scaled " + rest, long_wave, 0.25, 0.5),
                    {10.5 * 11.5, 40.5 * 10.5, 48.5 * 9.5, 56.5 * 8.5});
}

TEST_F(SpectralPattern, SpecfuncIsTheMeanOverEachBand) {
    test::write_file(folder_ / "f.cal", "line(nm) = A3*nm/1000 + Px;");
    test::TracedScene scene("void specfunc p 2 line " + (folder_ / "f.cal") +
                                " 0 3 12000 8000 2 p glow m 0 0 4 1 1 1 0" + test::plate,
                            {}, long_wave);
    constexpr int rays = 400;
    Spectrum sum(4);
    for (int n = 0; n < rays; ++n) sum += scene.radiance({0.5, 0, 3}, {0, 0, -1});
    // four samples a channel, each spread over nine tenths of its 250 nm
    const double deviation = 2 * 0.25 * 0.9 / std::sqrt(12.0 * 4 * rays);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(sum[c] / rays, 2 * (11.5 - c) + 0.5, 4 * deviation);
}

TEST_F(SpectralPattern, SpecfuncIsZeroWhereItIsNotDefined) {
    test::write_file(folder_ / "f.cal", "one(nm) = 1;");
    const std::string one = "void specfunc p 2 one " + (folder_ / "f.cal") + " 0 2 ";
    expect_channels(above(one + "9500 11000", long_wave), {0, 1, 0.5, 0});
    expect_channels(above(one + "3000 15000", long_wave), {1, 1, 1, 1});
}

TEST_F(SpectralPattern, IsAColorInRgb) {
    const std::vector<double> values = {0.2, 0.9, 0.4, 0.8, 0.1};
    const Spectrum color = resample(Channels(), values, 330, 830);
    const Spectrum seen = above("void spectrum p 0 0 7 380 780 .2 .9 .4 .8 .1", Channels());
    for (int c = 0; c < 3; ++c) EXPECT_EQ(seen[c], color[c]);
    test::write_file(folder_ / "f.cal", "one(nm) = 1;");
    const Spectrum white = above("void specfunc p 2 one " + (folder_ / "f.cal") + " 0 2 380 780", Channels());
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 0.002);
}

TEST_F(SpectralPattern, WarnsOfSpectraThatTheRenderingDoesNotReach) {
    test::write_file(folder_ / "s.dat", "1 380 780 3 1 2 3");
    test::write_file(folder_ / "f.cal", "one(nm) = 1; two(v,nm) = v;");
    test::write_file(folder_ / "d.dat", "2 0 1 2 380 780 3 1 2 3 4 5 6");
    const std::string cal = (folder_ / "f.cal") + " ";
    for (const std::string& pattern :
         {std::string("void spectrum p 0 0 5 380 780 1 2 3"),
          "void specfile p 1 " + (folder_ / "s.dat") + " 0 0", "void specfunc p 2 one " + cal + "0 2 380 780",
          "void specdata p 4 two " + (folder_ / "d.dat") + " " + cal + "Px 0 0"}) {
        const std::vector<std::string> said = warnings(pattern, long_wave);
        ASSERT_EQ(said.size(), 1u) << pattern;
        EXPECT_NE(said[0].find("of 380 to 780 nm says nothing about a rendering of 8000 to 12000 nm"),
                  std::string::npos)
            << said[0];
        EXPECT_TRUE(warnings(pattern, Channels::spectral(8, 300, 2000)).empty()) << pattern;
    }
    // as in RADIANCE a function is then left out, the others are 0
    expect_channels(above("void specfunc p 2 one " + cal + "0 2 380 780", long_wave), {1, 1, 1, 1});
    expect_channels(above("void spectrum p 0 0 5 380 780 1 2 3", long_wave), {0, 0, 0, 0});
}

}  // namespace
}  // namespace infra
