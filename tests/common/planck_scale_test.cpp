#include "common/planck/planck_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "common/error.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;

TEST(RadianceScale, MapsManyValuesAndBack) {
    const RadianceScale scales[] = {RadianceScale::of_band(8, 12),
                                    RadianceScale::of_response(SpectralResponse::parse("8 1\n12 1\n", "r"))};
    const std::vector<double> temperatures = {150, 250, 300, 350, 3000};
    for (const RadianceScale& scale : scales) {
        std::vector<double> values(temperatures.size());
        scale.radiances(temperatures, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i] / band_radiance(temperatures[i], 8, 12), 1, 1e-11);
        scale.temperatures(values, values);
        for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], temperatures[i], 1e-8);
        scale.slopes(temperatures, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i] / band_radiance_slope(temperatures[i], 8, 12), 1, 1e-11);
    }
}

TEST(RadianceScale, NamesTheValueThatIsWrong) {
    const RadianceScale scale = RadianceScale::of_band(8, 12);
    std::array<double, 3> values = {300, 310, -1};
    EXPECT_EQ(error_of([&] { scale.radiances(values, values); }),
              "value 3: temperature -1 K is not above absolute zero");
    EXPECT_THROW(scale.radiances(values, std::span(values).first(2)), Error);
}

TEST(RadianceScale, ReadsAndWritesBands) {
    for (const char* text : {"8-12 um", "8..12 um", "8 12", "8.0-12", "8 - 12 µm"})
        EXPECT_EQ(RadianceScale::parse(text).description(), "8-12 um") << text;
    EXPECT_EQ(RadianceScale::of_band(3.4, 4.95).description(), "3.4-4.95 um");
    EXPECT_EQ(RadianceScale::of_response(SpectralResponse::parse("8 1\n9 1\n", "a.txt")).description(),
              "response a.txt");
    for (const char* text : {"", "-", "8", "8-", "8-12 nm", "8-12-14", "response a.txt", "8 12 um 3"})
        EXPECT_EQ(error_of([&] { RadianceScale::parse(text); }),
                  "\"" + std::string(text) + "\" is not a band (as in \"8-12 um\")");
}

TEST(RadianceScale, RefusesBandsThatAreReversedOrOfAnotherUnit) {
    EXPECT_EQ(error_of([] { RadianceScale::of_band(12, 8); }),
              "band 12..8 um is empty or reversed (give the shorter wavelength first, in micrometres)");
    EXPECT_EQ(error_of([] { RadianceScale::parse("8000-12000 um"); }),
              "band 8000..12000 um is not within 0.2..1000 um (wavelengths are in micrometres)");
    EXPECT_THROW(RadianceScale::of_band(0, 8), Error);
    EXPECT_THROW(RadianceScale::of_band(std::nan(""), 8), Error);
}

}  // namespace
}  // namespace infra
