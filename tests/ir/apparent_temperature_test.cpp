#include "ir/apparent_temperature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/error.h"
#include "pictures.h"

namespace infra::ir {
namespace {

TEST(TemperatureTable, IsTheInverseOfTheBandOrResponse) {
    const RadianceScale scales[] = {
        RadianceScale::of_band(3, 5), RadianceScale::of_band(8, 12), RadianceScale::of_band(0.2, 1000),
        RadianceScale::of_band(9.99, 10),
        RadianceScale::of_response(SpectralResponse::parse("7.5 0\n8.5 .9\n11 1\n14 0\n", "r"))};
    for (const RadianceScale& scale : scales) {
        const TemperatureTable table(scale);
        for (double kelvin = 150; kelvin <= 3000; kelvin *= 1.0037)
            EXPECT_NEAR(table(scale.at(kelvin).radiance), kelvin, 1e-5) << scale.description();
        EXPECT_NEAR(table(scale.at(20).radiance), 20, 1e-4) << scale.description();
        EXPECT_NEAR(table(scale.at(50000).radiance), 50000, 1e-2) << scale.description();
    }
}

TEST(TemperatureTable, HasNoTemperatureForWhatIsNoRadiance) {
    const TemperatureTable table(RadianceScale::of_band(8, 12));
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double radiance : {0.0, -1.0, std::nan(""), infinite, -infinite, 1e20})
        EXPECT_TRUE(std::isnan(table(radiance))) << radiance;
}

TEST(ApparentTemperature, TurnsEveryChannelAndSaysSo) {
    Picture picture = ramp(2, 1, 2);
    picture.pixels = {38.50042f, 31.4780f, 0, 37.3463f};
    picture.header.lines = {"rpict", "BAND= 3-5 um", "UNIT= W.m-2.sr-1", "QUANTITY= radiance"};
    const RadianceScale scale = RadianceScale::of_band(8, 12);
    const Picture kelvin = apparent_temperature(picture, scale, TemperatureUnit::kelvin);
    EXPECT_NEAR(kelvin.pixels[0], 300, 1e-4);
    EXPECT_NEAR(kelvin.pixels[1], 288.15, 1e-4);
    EXPECT_TRUE(std::isnan(kelvin.pixels[2]));
    EXPECT_NEAR(kelvin.pixels[3], 298.15, 1e-4);
    EXPECT_EQ(kelvin.header.lines, (std::vector<std::string>{"rpict", "BAND= 8-12 um",
                                                             "QUANTITY= apparent temperature", "UNIT= K"}));
    const Picture celsius = apparent_temperature(picture, scale, TemperatureUnit::celsius);
    EXPECT_NEAR(celsius.pixels[3], 25, 1e-4);
    EXPECT_EQ(celsius.header.value("UNIT"), "degC");
    EXPECT_THROW(apparent_temperature(kelvin, scale, TemperatureUnit::kelvin), Error);
}

}  // namespace
}  // namespace infra::ir
