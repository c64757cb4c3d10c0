#include "common/planck/planck.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.h"

namespace infra {
namespace {

// Planck's law integrated by 5-point Gauss-Legendre over 400 pieces, independent of the series in use.
double quadrature(double temperature, double lo_um, double hi_um) {
    using namespace constants;
    constexpr std::array<double, 5> nodes = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                             -0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                               0.2369268850561891, 0.2369268850561891};
    constexpr int pieces = 400;
    const double first_radiation = 2 * planck * light_speed * light_speed;
    double sum = 0;
    const double half = 0.5 * (hi_um - lo_um) / pieces;
    for (int piece = 0; piece < pieces; ++piece)
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const double um = lo_um + half * (2 * piece + 1 + nodes[n]);
            const double m = um * 1e-6;
            sum += weights[n] * first_radiation / std::pow(m, 5) /
                   std::expm1(second_radiation_um / (um * temperature));
        }
    return sum * half * 1e-6;
}

struct Row {
    double temperature;
    double mid_wave, long_wave, wide_long_wave, total;  ///< 3-5, 8-12, 8-14 um, all
};
// VALIDATION V1, to the digits printed there
constexpr Row table[] = {{250, 0.21703, 14.55930, 22.29229, 70.5053},
                         {300, 1.86596, 38.50042, 54.93346, 146.1998},
                         {350, 8.97435, 78.03554, 106.44447, 270.8532}};

TEST(Planck, GivesTheValidationTable) {
    constexpr double digits = 5.1e-6, total_digits = 5.1e-5;
    for (const Row& row : table) {
        EXPECT_NEAR(band_radiance(row.temperature, 3, 5), row.mid_wave, digits);
        EXPECT_NEAR(band_radiance(row.temperature, 8, 12), row.long_wave, digits);
        EXPECT_NEAR(band_radiance(row.temperature, 8, 14), row.wide_long_wave, digits);
        EXPECT_NEAR(band_radiance(row.temperature, 0, std::numeric_limits<double>::infinity()), row.total,
                    total_digits);
    }
}

TEST(Planck, AgreesWithQuadratureToOneInAMillion) {
    for (const double temperature : {150.0, 250.0, 300.0, 350.0, 600.0, 1500.0, 5772.0})
        for (const auto& [lo, hi] :
             {std::pair{3.0, 5.0}, {8.0, 12.0}, {8.0, 14.0}, {3.9, 4.1}, {2.0, 30.0}}) {
            const double expected = quadrature(temperature, lo, hi);
            EXPECT_NEAR(band_radiance(temperature, lo, hi) / expected, 1, 1e-6)
                << temperature << " K, " << lo << ".." << hi << " um";
        }
}

TEST(Planck, GivesThePanelsTheirRadiances) {
    EXPECT_NEAR(band_radiance(288.15, 8, 12), 31.4780, 5.1e-5);
    EXPECT_NEAR(band_radiance(293.15, 8, 12), 34.3344, 5.1e-5);
    EXPECT_NEAR(band_radiance(298.15, 8, 12), 37.3463, 5.1e-5);
}

TEST(Planck, FractionsHaveTheirKnownValuesAndLimits) {
    EXPECT_NEAR(blackbody_fraction(2898), 0.250106, 5.1e-7);
    EXPECT_NEAR(blackbody_fraction(4107), 0.499956, 5.1e-7);
    EXPECT_NEAR(blackbody_fraction(10000), 0.914157, 5.1e-7);
    EXPECT_EQ(blackbody_fraction(0), 0);
    EXPECT_EQ(blackbody_fraction(std::numeric_limits<double>::infinity()), 1);
}

TEST(Planck, FractionIsContinuousWhereTheSeriesChange) {
    const double change = constants::second_radiation_um;  // x = 1
    EXPECT_NEAR(blackbody_fraction(change * (1 - 1e-12)), blackbody_fraction(change * (1 + 1e-12)), 1e-11);
    double before = 0;
    for (double lt = 100; lt < 1e6; lt *= 1.05) {
        const double fraction = blackbody_fraction(lt);
        EXPECT_GT(fraction, before);
        EXPECT_LE(fraction, 1);
        before = fraction;
    }
}

// Where the difference of two fractions would have lost most digits.
TEST(Planck, IsExactInNarrowAndFarBands) {
    struct Case {
        double temperature, lo_um, hi_um;
    };
    for (const Case& c : {Case{300, 9.999, 10},
                          {3000, 900, 1000},
                          {3000, 999, 1000},
                          {150, 10, 10.0001},
                          {14387.8, 0.9, 1.1},
                          {600, 20, 30},
                          {150, 3, 5},
                          {150, 0.25, 0.3}})
        EXPECT_NEAR(
            band_radiance(c.temperature, c.lo_um, c.hi_um) / quadrature(c.temperature, c.lo_um, c.hi_um), 1,
            1e-11)
            << c.temperature << " K, " << c.lo_um << ".." << c.hi_um << " um";
}

TEST(Planck, SpectralRadianceIsWhatTheBandIntegrates) {
    EXPECT_NEAR(spectral_radiance(300, 10), 9.924033330, 1e-8);
    EXPECT_NEAR(band_radiance(300, 9.999, 10.001) / 0.002 / spectral_radiance(300, 10), 1, 1e-7);
    EXPECT_EQ(spectral_radiance(1, 0.2), 0);
    EXPECT_THROW(spectral_radiance(0, 10), Error);
    EXPECT_THROW(spectral_radiance(300, 0), Error);
    EXPECT_THROW(spectral_radiance(300, std::nan("")), Error);
}

constexpr std::array<std::pair<double, double>, 8> bands = {
    {{3, 5}, {8, 12}, {8, 14}, {0.2, 1000}, {9.99, 10}, {3.7, 4.2}, {100, 1000}, {0.2, 0.4}}};

TEST(Planck, SlopeIsTheDerivative) {
    for (const double temperature : {150.0, 300.0, 1000.0, 3000.0})
        for (const auto& [lo, hi] : bands) {
            const double step = 1e-4 * temperature;
            const double rise =
                8 * (band_radiance(temperature + step, lo, hi) - band_radiance(temperature - step, lo, hi)) -
                (band_radiance(temperature + 2 * step, lo, hi) -
                 band_radiance(temperature - 2 * step, lo, hi));
            const double slope = band_radiance_slope(temperature, lo, hi);
            EXPECT_NEAR(slope * 12 * step / rise, 1, 1e-7)
                << temperature << " K, " << lo << ".." << hi << " um";
            EXPECT_EQ(slope, band_thermal_radiance(temperature, lo, hi).slope);
        }
}

TEST(Planck, TemperatureIsFoundAgain) {
    for (const auto& [lo, hi] : bands)
        for (double temperature = 150; temperature <= 3000; temperature *= 1.013)
            EXPECT_NEAR(band_temperature(band_radiance(temperature, lo, hi), lo, hi), temperature, 1e-8)
                << lo << ".." << hi << " um";
    for (const double temperature : {3.0, 20.0, 5772.0, 9e4})
        EXPECT_NEAR(band_temperature(band_radiance(temperature, 8, 12), 8, 12) / temperature, 1, 1e-10);
}

TEST(Planck, RefusesRadiancesWithoutTemperature) {
    for (const double radiance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e12})
        EXPECT_THROW(band_temperature(radiance, 8, 12), Error) << radiance;
    EXPECT_THROW(band_temperature(1, 12, 8), Error);
    EXPECT_THROW(band_radiance_slope(-3, 8, 12), Error);
    try {
        band_temperature(1e12, 8, 12);
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "no temperature from 1 to 100000 K has the radiance 1e+12 (is it in W.m-2.sr-1 over the "
                     "band?)");
    }
}

TEST(Planck, RefusesWhatIsNoTemperatureOrBand) {
    for (const double temperature : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(band_radiance(temperature, 8, 12), Error) << temperature;
    EXPECT_THROW(band_radiance(300, 12, 8), Error);
    EXPECT_THROW(band_radiance(300, 8, 8), Error);
    EXPECT_THROW(band_radiance(300, -1, 8), Error);
    EXPECT_THROW(band_radiance(300, std::nan(""), 8), Error);
}

}  // namespace
}  // namespace infra
