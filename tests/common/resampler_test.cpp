// One Resampler for many spectra.
#include "common/spectra/resampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace infra {
namespace {

/// Means of nm^power over `count` equal bands.
std::vector<double> power_bands(double nm_first, double nm_last, std::size_t count, int power) {
    std::vector<double> values;
    const double step = (nm_last - nm_first) / static_cast<double>(count);
    const auto integral = [&](double nm) { return std::pow(nm, power + 1) / (power + 1); };
    for (std::size_t i = 0; i < count; ++i) {
        const double from = nm_first + step * static_cast<double>(i);
        values.push_back((integral(from + step) - integral(from)) / step);
    }
    return values;
}

TEST(Resampler, KeepsTheIntegralsOfEverySpectrum) {
    const Channels channels = Channels::spectral(5, 8000, 12000);
    const Resampler resampler(channels, 400, 7000, 13000);
    for (const int power : {0, 1, 2}) {
        const Spectrum means = resampler(power_bands(7000, 13000, 400, power));
        double mean = 0;
        for (int c = 0; c < 5; ++c) mean += means[c] / 5;
        const double expected = power_bands(8000, 12000, 1, power)[0];
        EXPECT_NEAR(mean, expected, 1e-4 * expected) << power;
    }
}

TEST(Resampler, KeepsNothingOfTheLastSpectrum) {
    const std::vector<double> first = power_bands(780, 380, 9, 1), second = power_bands(780, 380, 9, 2);
    for (const Channels& channels : {Channels(), Channels::spectral(4, 380, 780)}) {
        const Resampler resampler(channels, 9, 780, 380);
        resampler(first);
        const Spectrum again = resampler(second), alone = resample(channels, second, 780, 380);
        for (int c = 0; c < channels.count(); ++c) EXPECT_EQ(again[c], alone[c]);
    }
}

// More bands than 24 are averaged before they become a colour.
TEST(Resampler, AveragesFineSpectraForColors) {
    const Spectrum fine = resample(Channels(), power_bands(780, 380, 240, 2), 780, 380);
    const Spectrum coarse = resample(Channels(), power_bands(780, 380, 24, 2), 780, 380);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fine[c], coarse[c], 1e-5 * coarse[c]);
}

}  // namespace
}  // namespace infra
