// What -p and -co make of a radiance. Expected figures are RADIANCE 6.1's.
#include "rt/programs/value_converter.h"

#include <gtest/gtest.h>

#include <vector>

namespace infra {
namespace {

using Kind = OutputColor::Kind;

std::vector<float> numbers(Kind kind, const Channels& channels, const Spectrum& value) {
    const ValueConverter converter({.kind = kind}, channels);
    const ValueConverter::Numbers result = converter.radiance(value);
    EXPECT_EQ(result.count, converter.components());
    return {result.values.begin(), result.values.begin() + result.count};
}

void expect_near(const std::vector<float>& values, const std::vector<double>& expected) {
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], expected[i], 1e-3 * expected[i]) << "number " << i;
}

TEST(ValueConverter, GivesRadiancesNumbersForRgb) {
    Spectrum rgb(3);
    for (int c = 0; c < 3; ++c) rgb.set(c, static_cast<float>(c + 1));
    EXPECT_EQ(numbers(Kind::rgb, Channels(), rgb), (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(numbers(Kind::spectrum, Channels(), rgb), (std::vector<float>{1, 2, 3}));
    expect_near(numbers(Kind::xyz, Channels(), rgb), {294.9609, 322.1432, 506.3813});
    expect_near(numbers(Kind::photopic, Channels(), rgb), {322.1432});
    expect_near(numbers(Kind::scotopic, Channels(), rgb), {934.6211});
    expect_near(numbers(Kind::melanopic, Channels(), rgb), {428.8926});
    EXPECT_EQ(numbers(Kind::average, Channels(), rgb), std::vector<float>{2});
}

TEST(ValueConverter, GivesRadiancesNumbersForBands) {
    const Channels channels = Channels::spectral(20, 380, 780);
    const Spectrum value = channels.from_rgb(1, 2, 3);
    expect_near(numbers(Kind::rgb, channels, value), {0.9440938, 1.905460, 3.069913});
    expect_near(numbers(Kind::xyz, channels, value), {286.3618, 308.9611, 514.7366});
    expect_near(numbers(Kind::photopic, channels, value), {308.9611});
    expect_near(numbers(Kind::scotopic, channels, value), {931.2514});
    EXPECT_EQ(numbers(Kind::spectrum, channels, value).size(), 20u);
    EXPECT_EQ(numbers(Kind::spectrum, channels, value)[9], 1);
}

TEST(ValueConverter, GivesSharesNoUnit) {
    const ValueConverter converter({.kind = Kind::photopic}, Channels());
    EXPECT_NEAR(converter.share(Spectrum(3, 0.5f)).values[0], 0.5, 1e-6);
    EXPECT_NEAR(converter.radiance(Spectrum(3, 0.5f)).values[0], 0.5 * 179, 1e-4);
}

TEST(ValueConverter, ShowsTheInfraredInThirds) {
    const Channels channels = Channels::spectral(7, 8000, 12000);
    const Channels nine = Channels::spectral(9, 8000, 12000);
    const std::vector<float> thirds = numbers(Kind::rgb, nine, nine.from_rgb(1, 2, 3));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(thirds[static_cast<std::size_t>(i)], i + 1, 1e-6);
    // A channel on the border gives to both sides, so that the mean of the thirds is that of the channels.
    Spectrum uneven(7);
    uneven.set(2, 7);
    const std::vector<float> shared = numbers(Kind::rgb, channels, uneven);
    EXPECT_NEAR(shared[0], 1, 1e-6);
    EXPECT_NEAR(shared[1], 2, 1e-6);
    EXPECT_EQ(shared[2], 0);
    EXPECT_NE(color_warning({.kind = Kind::rgb}, channels), "");
    EXPECT_NE(color_warning({.kind = Kind::scotopic}, channels), "");
    EXPECT_EQ(color_warning({.kind = Kind::spectrum}, channels), "");
    EXPECT_EQ(color_warning({.kind = Kind::rgb}, Channels::spectral(7, 380, 780)), "");
    EXPECT_EQ(numbers(Kind::photopic, channels, Spectrum(7, 1.0f)), std::vector<float>{0});
}

}  // namespace
}  // namespace infra
