#include "common/planck/planck_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;

SpectralResponse parsed(const std::string& text) { return SpectralResponse::parse(text, "lwir.txt"); }

/// Midpoint rule over a million wavelengths, with the weights by themselves.
double brute_force(const SpectralResponse& response, double temperature) {
    double sum = 0;
    for (std::size_t i = 1; i < response.samples().size(); ++i) {
        const auto &a = response.samples()[i - 1], &b = response.samples()[i];
        constexpr int count = 200000;
        const double width = (b.wavelength_um - a.wavelength_um) / count;
        for (int k = 0; k < count; ++k) {
            const double t = (k + 0.5) / count;
            const double um = a.wavelength_um + t * (b.wavelength_um - a.wavelength_um);
            sum += (a.weight + t * (b.weight - a.weight)) * spectral_radiance(temperature, um) * width;
        }
    }
    return sum;
}

const char* const detector =
    "# um weight\n"
    "7.5 0\n"
    "8 .2   # edge\n"
    "\n"
    "8.5\t0.9\r\n"
    "11 1\n"
    "12 .95\n"
    "14 0\n"
    "20 0\n";

TEST(SpectralResponse, FlatWeightsGiveTheBand) {
    const SpectralResponse two = parsed("8 1\n12 1\n"), wide = parsed("0.2 2\n1000 2\n");
    for (const double temperature : {150.0, 250.0, 300.0, 350.0, 1000.0, 3000.0}) {
        EXPECT_NEAR(two.thermal_radiance(temperature).radiance / band_radiance(temperature, 8, 12), 1, 1e-11);
        EXPECT_NEAR(two.thermal_radiance(temperature).slope / band_radiance_slope(temperature, 8, 12), 1,
                    1e-11);
        EXPECT_NEAR(wide.thermal_radiance(temperature).radiance / band_radiance(temperature, 0.2, 1000), 2,
                    2e-11);
    }
}

TEST(SpectralResponse, FlatWeightsGiveTheValidationTable) {
    EXPECT_NEAR(parsed("3 1\n5 1\n").thermal_radiance(300).radiance, 1.86596, 5.1e-6);
    EXPECT_NEAR(parsed("8 1\n12 1\n").thermal_radiance(300).radiance, 38.50042, 5.1e-6);
    EXPECT_NEAR(parsed("8 1\n9 1\n14 1\n").thermal_radiance(300).radiance, 54.93346, 5.1e-6);
}

TEST(SpectralResponse, WeightsAreLinearBetweenSamples) {
    const SpectralResponse response = parsed(detector);
    for (const double temperature : {200.0, 300.0, 800.0})
        EXPECT_NEAR(response.thermal_radiance(temperature).radiance / brute_force(response, temperature), 1,
                    1e-9);
}

TEST(SpectralResponse, SlopeIsTheDerivativeAndTemperatureIsFoundAgain) {
    const SpectralResponse response = parsed(detector);
    for (double temperature = 150; temperature <= 3000; temperature *= 1.1) {
        const double step = 1e-4 * temperature;
        const double rise = response.thermal_radiance(temperature + step).radiance -
                            response.thermal_radiance(temperature - step).radiance;
        const ThermalRadiance at = response.thermal_radiance(temperature);
        EXPECT_NEAR(at.slope * 2 * step / rise, 1, 1e-5);
        EXPECT_NEAR(response.temperature(at.radiance), temperature, 1e-8);
    }
}

TEST(SpectralResponse, ReadsAFile) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "r.txt", detector);
    const SpectralResponse response = SpectralResponse::read(folder / "r.txt");
    ASSERT_EQ(response.samples().size(), 7u);
    EXPECT_EQ(response.samples()[2].wavelength_um, 8.5);
    EXPECT_EQ(response.samples()[2].weight, 0.9);
    EXPECT_EQ(response.name(), folder / "r.txt");
    EXPECT_NE(error_of([&] { SpectralResponse::read(folder / "none.txt"); }).find("none.txt"),
              std::string::npos);
}

TEST(SpectralResponse, SaysWhatIsWrongAndWhere) {
    const std::pair<const char*, const char*> cases[] = {
        {"8 1\n9\n", "lwir.txt:2: expected 2 columns, found 1 (a line is a wavelength in um and a weight)"},
        {"8 1 1\n", "lwir.txt:1: expected 2 columns, found 3 (a line is a wavelength in um and a weight)"},
        {"8 1\nnine 1\n", "lwir.txt:2: \"nine\" is not a number"},
        {"8 1\n9 nan\n", "lwir.txt:2: \"nan\" is not a number"},
        {"8 1\n# x\n8 1\n", "lwir.txt:3: wavelength 8 um does not come after 8 um"},
        {"9 1\n8 1\n", "lwir.txt:2: wavelength 8 um does not come after 9 um"},
        {"8 1\n9 -.1\n", "lwir.txt:2: weight -0.1 is negative"},
        {"8000 1\n9000 1\n",
         "lwir.txt:1: wavelength 8000 um is not within 0.2..1000 um (wavelengths are in micrometres)"},
        {"-8 1\n",
         "lwir.txt:1: wavelength -8 um is not within 0.2..1000 um (wavelengths are in micrometres)"},
        {"8 0\n9 0\n", "lwir.txt:2: all weights are 0"},
        {"8 1\n",
         "lwir.txt:1: a response needs at least 2 samples, found 1 (a line is a wavelength in um and "
         "a weight)"},
        {"",
         "lwir.txt:1: a response needs at least 2 samples, found 0 (a line is a wavelength in um and a "
         "weight)"},
    };
    for (const auto& [text, expected] : cases) EXPECT_EQ(error_of([&] { parsed(text); }), expected) << text;
    const SpectralResponse response = parsed(detector);
    EXPECT_THROW(response.thermal_radiance(0), Error);
    EXPECT_THROW(response.thermal_radiance(std::nan("")), Error);
    EXPECT_THROW(response.temperature(0), Error);
}

}  // namespace
}  // namespace infra
