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
        spectrum.place.push_back(wavenumber);
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

// Samples 1 um apart. A spectrum per um by wavelength is a line there, and so is one per cm^-1 by wavenumber.
TEST(SampledSpectrum, IntegratesStraightLinesAlongTheFilesOwnAxis) {
    SampledSpectrum spectrum{"file", {8, 9, 10, 11, 12}, {1, 1, 1, 1, 1}};
    spectrum.axis = spectrum.density = SpectralAxis::wavelength;
    EXPECT_NEAR(band_integral(spectrum, Passband::of_band(8, 12)), 4, 1e-13);
    EXPECT_NEAR(band_integral(spectrum, Passband::of_band(8.5, 9.25)), .75, 1e-13);
    spectrum.value = {0, 2, 1, 5, 3};
    EXPECT_NEAR(band_integral(spectrum, Passband::of_band(8, 12)), 1 + 1.5 + 3 + 4, 1e-13);
    spectrum.axis = spectrum.density = SpectralAxis::wavenumber;
    spectrum.place = {800, 900, 1000, 1200, 1300};
    EXPECT_NEAR(band_integral(spectrum, Passband::of_band(1e4 / 1300, 1e4 / 800)), 100 + 150 + 600 + 400,
                1e-10);
}

// Per cm^-1 by wavelength: of L = um the integral of um d(1e4/um), 1e4 ln(12/8).
TEST(SampledSpectrum, IntegratesADensityOfTheOtherAxis) {
    SampledSpectrum spectrum{"file", {8, 9, 10, 11, 12}, {8, 9, 10, 11, 12}};
    spectrum.axis = SpectralAxis::wavelength;
    const double expected = 1e4 * std::log(12. / 8);
    EXPECT_NEAR(band_integral(spectrum, Passband::of_band(8, 12)), expected, 1e-9 * expected);
}

TEST(SampledSpectrum, MeanOfATransmittanceByWavelength) {
    SampledSpectrum line{"file", {8, 12}, {.2, .6}};
    line.axis = SpectralAxis::wavelength;
    SampledSpectrum fine{"file", {}, {}};
    for (double wavenumber = 1e4 / 12; wavenumber < 1251; wavenumber += .25) {
        fine.place.push_back(wavenumber);
        fine.value.push_back(.2 + .1 * (1e4 / wavenumber - 8));
    }
    const Passband band = Passband::of_band(8, 12);
    EXPECT_NEAR(band_mean(line, band, 300), band_mean(fine, band, 300), 1e-7);
}

TEST(SampledSpectrum, RefusesABandBeyondTheFile) {
    const SampledSpectrum spectrum = black_body(300, 800, 1200, 1);
    EXPECT_EQ(error_of([&] { band_integral(spectrum, Passband::of_band(8, 12)); }),
              "file:1: the band 8-12 um (833.333-1250 cm-1) reaches beyond the file's 800-1200 cm-1");
}

}  // namespace
}  // namespace infra::ir
