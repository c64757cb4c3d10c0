// Spectra to channels and channels to colours, against numbers that RADIANCE 6.1 prints for the same spectra.
#include <gtest/gtest.h>

#include <vector>

#include "common/spectra/resampler.h"

namespace {

using namespace infra;

const std::vector<double> six_bands = {0.1, 0.3, 0.9, 0.5, 0.2, 0.1};  // of 340-820 nm, shortest first

Spectrum spectrum_of(const std::vector<double>& values) {
    Spectrum result(static_cast<int>(values.size()));
    for (int c = 0; c < result.channels(); ++c)
        result.set(c, static_cast<float>(values[static_cast<std::size_t>(c)]));
    return result;
}

template <class Values>
void expect_near(const Values& values, const std::vector<double>& expected, double relative) {
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(values[static_cast<int>(i)], expected[i], relative * expected[i]) << "value " << i;
}

TEST(SpectralColor, BandsAreMeansOverTheirOverlap) {
    const Channels channels = Channels::spectral(4, 800, 400);
    const std::vector<double> values = {1, 2, 3, 4};  // 750-550 nm, 50 nm each
    expect_near(resample(channels, values, 750, 550), {0.5, 2.5, 2, 0}, 1e-6);
    const std::vector<double> turned = {4, 3, 2, 1};
    expect_near(resample(channels, turned, 550, 750), {0.5, 2.5, 2, 0}, 1e-6);
}

TEST(SpectralColor, NothingOutsideTheSpectrum) {
    const Spectrum bands = resample(Channels::spectral(3, 8000, 12000), six_bands, 340, 820);
    EXPECT_EQ(bands.maximum(), 0);
}

TEST(SpectralColor, SpectrumToRgb) {
    expect_near(resample(Channels(), six_bands, 340, 820), {0.5656558, 0.6978400, 0.2817992}, 1e-3);
}

TEST(SpectralColor, ThreeValuesLongestFirstAreRgb) {
    const std::vector<double> values = {3, 2, 1};
    expect_near(resample(Channels(), values, 700, 400), {3, 2, 1}, 0);
}

const std::vector<double> twenty_bands = {.1, .1, .2, .2, .2, .2, .5, .5, .5, .5,
                                          .9, .9, .9, .9, .3, .3, .3, .3, .1, .1};

TEST(SpectralColor, FinerBandsRepeatValues) {
    const Spectrum bands = resample(Channels::spectral(20, 380, 780), six_bands, 340, 820);
    expect_near(bands, twenty_bands, 1e-6);
}

TEST(SpectralColor, ChannelsToColorsAndResponses) {
    const Channels channels = Channels::spectral(20, 380, 780);
    const Spectrum spectrum = spectrum_of(twenty_bands);
    expect_near(ColorConverter::xyz(channels)(spectrum), {101.3467 / 179, 131.1375 / 179, 55.48276 / 179},
                1e-3);
    const Primaries wide = {{.7, .3}, {.2, .7}, {.13, .05}, {.31, .33}};
    expect_near(ColorConverter::rgb(channels, wide)(spectrum), {0.5454031, 0.8528336, 0.2563945}, 1e-3);
    EXPECT_NEAR(Response(channels, EyeResponse::y)(spectrum), 131.1375 / 179, 5e-4);
    EXPECT_NEAR(Response(channels, EyeResponse::scotopic)(spectrum), 252.1885 / 412, 5e-4);
    EXPECT_NEAR(Response(channels, EyeResponse::melanopic)(spectrum), 93.38946 / 179, 5e-4);
}

TEST(SpectralColor, EqualEnergyIsWhite) {
    const Channels channels = Channels::spectral(9, 360, 830);
    const Spectrum grey(9, 2.0f);
    expect_near(ColorConverter::xyz(channels)(grey), {2, 2, 2}, 1e-3);
    expect_near(ColorConverter::rgb(channels)(grey), {2, 2, 2}, 1e-3);
    expect_near(ColorConverter::xyz(Channels())(spectrum_of({2, 2, 2})), {2, 2, 2}, 1e-6);
    for (const EyeResponse response : {EyeResponse::x, EyeResponse::scotopic, EyeResponse::melanopic}) {
        EXPECT_NEAR(Response(channels, response)(grey), 2, 1e-3);
        EXPECT_NEAR(Response(Channels(), response)(spectrum_of({2, 2, 2})), 2, 1e-3);
    }
}

TEST(SpectralColor, RgbIsKept) {
    expect_near(ColorConverter::rgb(Channels())(spectrum_of({3, 2, 1})), {3, 2, 1}, 0);
}

TEST(SpectralColor, RgbInOtherPrimariesAndResponses) {
    const Spectrum rgb = spectrum_of({1, 2, 3});
    const Primaries wide = {{.7, .3}, {.2, .7}, {.13, .05}, {.31, .33}};
    expect_near(ColorConverter::rgb(Channels(), wide)(rgb), {1.266923, 1.927524, 2.915472}, 1e-3);
    expect_near(ColorConverter::xyz(Channels())(rgb), {294.9609 / 179, 322.1432 / 179, 506.3813 / 179}, 1e-4);
    EXPECT_NEAR(Response(Channels(), EyeResponse::scotopic)(rgb), 934.6211 / 412, 1e-3);
    EXPECT_NEAR(Response(Channels(), EyeResponse::melanopic)(rgb), 428.8926 / 179, 1e-3);
}

TEST(SpectralColor, InfraredShowsMeansOfThirds) {
    const Channels channels = Channels::spectral(6, 8000, 12000);
    expect_near(ColorConverter::rgb(channels)(spectrum_of({1, 3, 5, 7, 9, 11})), {2, 6, 10}, 1e-6);
}

TEST(SpectralColor, ColorsOutsideTheGamutKeepTheirLuminance) {
    const Channels channels = Channels::spectral(24, 380, 780);
    Spectrum line(24);
    line.set(16, 1);  // about 505 nm
    const Color rgb = ColorConverter::rgb(channels)(line);
    for (const float value : rgb) EXPECT_GE(value, 0);
    EXPECT_EQ(rgb[0], 0);
    EXPECT_NEAR(Response(Channels(), EyeResponse::y)(spectrum_of({rgb[0], rgb[1], rgb[2]})),
                Response(channels, EyeResponse::y)(line), 1e-6);
}

TEST(SpectralColor, PrimariesThatSpanNoPlaneAreUnusable) {
    EXPECT_TRUE(usable(radiance_primaries()));
    EXPECT_TRUE(usable({{1, 0}, {0, 1}, {0, 0}, {1. / 3, 1. / 3}}));  // X, Y and Z themselves
    EXPECT_FALSE(usable({{.3, .3}, {.3, .3}, {.15, .06}, {1. / 3, 1. / 3}}));
    EXPECT_FALSE(usable({{.2, .2}, {.4, .4}, {.6, .6}, {1. / 3, 1. / 3.5}}));
    EXPECT_FALSE(usable({{.64, .33}, {.29, .6}, {.15, .06}, {.3, 0}}));
}

}  // namespace
