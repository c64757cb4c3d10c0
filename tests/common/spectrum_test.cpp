#include "common/spectra/spectrum.h"

#include <gtest/gtest.h>

namespace infra {
namespace {

Spectrum ramp(int channels, float first, float step) {
    Spectrum s(channels);
    for (int c = 0; c < channels; ++c) s.set(c, first + step * static_cast<float>(c));
    return s;
}

class AnySpectrum : public testing::TestWithParam<int> {};

TEST_P(AnySpectrum, DoesArithmeticChannelByChannel) {
    const int n = GetParam();
    const Spectrum a = ramp(n, 1, 1), b = ramp(n, 0.5f, -0.25f);
    Spectrum sum = a, difference = a, scaled = a, mixed = a, fused = a;
    sum += b;
    difference -= b;
    scaled *= 3.0f;
    mixed.add_scaled(b, 2.0f);
    fused.add_product(b, b);
    const Spectrum product = a * b, half = b * 0.5f;
    for (int c = 0; c < n; ++c) {
        EXPECT_EQ(sum[c], a[c] + b[c]);
        EXPECT_EQ(difference[c], a[c] - b[c]);
        EXPECT_EQ(scaled[c], a[c] * 3.0f);
        EXPECT_EQ(mixed[c], a[c] + b[c] * 2.0f);
        EXPECT_EQ(fused[c], a[c] + b[c] * b[c]);
        EXPECT_EQ(product[c], a[c] * b[c]);
        EXPECT_EQ(half[c], b[c] * 0.5f);
    }
}

TEST_P(AnySpectrum, SummarisesItsChannels) {
    const int n = GetParam();
    const Spectrum a = ramp(n, 1, 1);
    EXPECT_EQ(a.channels(), n);
    EXPECT_EQ(a.maximum(), static_cast<float>(n));
    EXPECT_FLOAT_EQ(a.mean(), static_cast<float>(n + 1) / 2);
    EXPECT_EQ(ramp(n, -5, -1).maximum(), 0.0f);
    EXPECT_FLOAT_EQ(Spectrum(n, 2.5f).mean(), 2.5f);
    EXPECT_NEAR(Spectrum(n, 2.5f).brightness(), 2.5f, 1e-6f);
    if (n == 3) return;
    EXPECT_EQ(a.brightness(), a.mean());
}

TEST_P(AnySpectrum, StartsBlackAndClears) {
    const int n = GetParam();
    Spectrum a(n);
    for (int c = 0; c < n; ++c) EXPECT_EQ(a[c], 0.0f);
    a.fill(7);
    for (int c = 0; c < n; ++c) EXPECT_EQ(a[c], 7.0f);
    a.clear();
    for (int c = 0; c < n; ++c) EXPECT_EQ(a[c], 0.0f);
}

TEST_P(AnySpectrum, IsAssignedWhateverItsSizeWas) {
    const Spectrum a = ramp(GetParam(), 1, 1);
    Spectrum b(Spectrum::max_channels, 9);
    b = a;
    EXPECT_EQ(b.channels(), a.channels());
    EXPECT_EQ(b.mean(), a.mean());
}

INSTANTIATE_TEST_SUITE_P(Channels, AnySpectrum, testing::Values(1, 2, 3, 4, 5, 8, 13, 24));

TEST(Spectrum, WeighsThreeChannelsAsRadianceDoes) {
    Spectrum green(3);
    green.set(1, 1);
    EXPECT_FLOAT_EQ(green.brightness(), 0.670114631f);
}

}  // namespace
}  // namespace infra
