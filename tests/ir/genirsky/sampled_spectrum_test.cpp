// Integrals over bands against closed forms.
#include "ir/genirsky/sampled_spectrum.h"

#include "common/planck/planck.h"
#include "fixtures.h"

namespace infra::ir {
namespace {

using test::error_of;

SampledSpectrum black_body(double temperature, double from, double to, double step) {
    SampledSpectrum spectrum{"file", {}, {}};
    for (double wavenumber = from; wavenumber <= to; wavenumber += step) {
        spectrum.wavenumber.push_back(wavenumber);
        spectrum.value.push_back(wavenumber_radiance(temperature, wavenumber));
    }
    return spectrum;
}

// 300 K ground seen through a transmittance of .88373 at 2050 cm-1: 4.871e-7 W cm^-2 sr^-1/cm^-1 as
// published, cut to four digits and with constants of its day.
TEST(SampledSpectrum, AgreesWithAKnownSurfaceRadiance) {
    constexpr double per_cm2 = 1e-4;
    EXPECT_NEAR(per_cm2 * .88373 * wavenumber_radiance(300, 2050), 4.871e-7, 0.001e-7);
    EXPECT_NEAR(per_cm2 * .88373 * wavenumber_radiance(300, 2050), 4.871964086e-7, 1e-16);  // of SI 2019
}

TEST(SampledSpectrum, IntegratesPlancksLaw) {
    const SampledSpectrum fine = black_body(300, 700, 1400, 1);
    EXPECT_NEAR(band_integral(fine, Passband::of_band(8, 12)), 38.50042, 4e-5);  // VALIDATION V1
    EXPECT_NEAR(band_integral(fine, Passband::of_band(9.0001, 9.0002)) / band_radiance(300, 9.0001, 9.0002),
                1, 1e-5);
    const SampledSpectrum coarse = black_body(300, 700, 1400, 20);
    EXPECT_NEAR(band_integral(coarse, Passband::of_band(8, 12)) / 38.50042, 1, 3e-4);
}

TEST(SampledSpectrum, WeightsByAResponse) {
    const auto response = SpectralResponse::parse("8 0\n9.3 1\n11 .7\n12.5 0\n", "response");
    const Passband passband = Passband::of_response(response);
    EXPECT_EQ(passband.weight(7.9), 0);
    EXPECT_EQ(passband.weight(9.3), 1);
    EXPECT_NEAR(passband.weight(10.15), .85, 1e-12);
    EXPECT_EQ(passband.weight(12.5), 0);
    EXPECT_NEAR(band_integral(black_body(300, 700, 1400, 1), passband),
                response.thermal_radiance(300).radiance, 1e-5);
}

TEST(SampledSpectrum, MeanOfAConstantIsTheConstant) {
    const SampledSpectrum grey{"file", {500, 3000}, {.37, .37}};
    EXPECT_NEAR(band_mean(grey, Passband::of_band(8, 12), 300), .37, 1e-12);
    EXPECT_NEAR(band_mean(grey, Passband::of_band(3.5, 12), 5772), .37, 1e-12);
}

// Half of the band is opaque: the mean is the clear half's share of the black body's radiance.
TEST(SampledSpectrum, MeanIsWeightedByTheBlackBody) {
    const SampledSpectrum step{"file", {500, 999.9999, 1000.0001, 3000}, {1, 1, 0, 0}};
    EXPECT_NEAR(band_mean(step, Passband::of_band(8, 12), 320),
                band_radiance(320, 10, 12) / band_radiance(320, 8, 12), 1e-4);
}

TEST(SampledSpectrum, RefusesABandBeyondTheFile) {
    const SampledSpectrum spectrum = black_body(300, 800, 1200, 1);
    EXPECT_EQ(error_of([&] { band_integral(spectrum, Passband::of_band(8, 12)); }),
              "file: the band 8-12 um (833.333-1250 cm-1) reaches beyond the file's 800-1200 cm-1");
}

}  // namespace
}  // namespace infra::ir
