#include "ir/genirsky/dome_file.h"

#include "common/planck/planck.h"
#include "fixtures.h"

namespace infra::ir {
namespace {

using test::error_of;

const ValueReader radiances(ValueUnit::radiance, nullptr);

NumberText numbers(const std::string& text) { return parse_numbers(text, "file"); }

/// Column r, row h holds 100 + 10 (r mod 20) + h.
std::string table_text(int columns) {
    std::string text;
    for (int r = 0; r < columns; ++r)
        for (int h = 0; h < 10; ++h) text += std::to_string(100 + 10 * (r % 20) + h) + (h == 9 ? "\n" : " ");
    return text;
}

TEST(DomeFile, ReadsTenValues) {
    const Dome dome = parse_elevations(numbers("1 2 3 4 5\n6 7 8 9 10\n"), radiances, false);
    EXPECT_EQ(dome.values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    const Dome turned = parse_elevations(numbers("1 2 3 4 5 6 7 8 9 10"), radiances, true);
    EXPECT_EQ(turned.values, (std::vector<double>{10, 9, 8, 7, 6, 5, 4, 3, 2, 1}));
}

TEST(DomeFile, InterpolatesAnglesAndValues) {
    const Dome dome = parse_elevations(numbers("5 1\n25 2\n85 5\n"), radiances, false);
    EXPECT_EQ(dome.values, (std::vector<double>{1, 1.25, 1.75, 2.25, 2.75, 3.25, 3.75, 4.25, 4.75, 5}));
}

TEST(DomeFile, ConvertsTemperatures) {
    const Passband band = Passband::of_band(8, 12);
    const NumberText text = numbers("15 16 17 18 19 20 21 22 23 24");
    const Dome dome = parse_elevations(text, ValueReader(ValueUnit::celsius, &band), false);
    EXPECT_NEAR(dome.values[0], 31.4780, 5e-5);
    EXPECT_NEAR(dome.values[5], 34.3344, 5e-5);
    const Dome cold = parse_elevations(text, ValueReader(ValueUnit::kelvin, &band), false);
    EXPECT_NEAR(cold.values[9], band_radiance(24, 8, 12), 1e-18);
}

TEST(DomeFile, ReadsTablesWithAndWithoutTheLastColumn) {
    const Dome whole = parse_dome_table(numbers(table_text(21)), radiances);
    EXPECT_EQ(whole.values.size(), 210u);
    EXPECT_EQ(whole.values[10 * 7 + 3], 173);
    EXPECT_EQ(parse_dome_table(numbers(table_text(20)), radiances).values, whole.values);
    EXPECT_EQ(Dome{std::vector<double>(10, 1.)}.with_azimuth().values, std::vector<double>(210, 1.));
}

TEST(DomeFile, ReadsThRendsLine) {
    const Passband band = Passband::of_band(8, 14);
    const std::string line = "233.6 235.4 238.4 242.6 248 254.6 262.4 271.4 281.6 293.0\n";
    const Dome dome = parse_thrend(numbers(line), ValueReader(ValueUnit::kelvin, &band), false);
    EXPECT_NEAR(dome.values[9], band_radiance(293, 8, 14), 1e-9);
    EXPECT_EQ(error_of([&] { parse_thrend(numbers(line + line), radiances, false); }),
              "file:2:1: ThRend's sky has one line of ten values");
}

TEST(DomeFile, MarksOddTemperatures) {
    const Passband band = Passband::of_band(8, 12);
    std::vector<std::string> odd;
    parse_elevations(numbers("0 100\n30 15\n60 400\n90 401\n"), ValueReader(ValueUnit::kelvin, &band, &odd),
                     false);
    parse_elevations(numbers("0 15\n90 288\n"), ValueReader(ValueUnit::celsius, &band, &odd), false);
    EXPECT_EQ(odd,
              (std::vector<std::string>{"file:2:4: temperature 15 K is below 100 K (degrees Celsius, -C?)",
                                        "file:4:4: temperature 401 K is above 400 K",
                                        "file:2:4: temperature 288 degrees C is above 400 K (kelvin, -K?)"}));
}

TEST(Dome, ItsPoleIsOneDirection) {
    Dome dome = parse_dome_table(numbers(table_text(21)), radiances);
    EXPECT_TRUE(dome.join_pole());
    for (int column = 0; column <= 20; ++column) {
        EXPECT_EQ(dome.values[10 * column], 195);
        EXPECT_EQ(dome.values[10 * column + 1], 101 + 10 * (column % 20));
    }
    EXPECT_FALSE(dome.join_pole());
    Dome even{std::vector<double>(10, 1.)};
    EXPECT_FALSE(even.join_pole());
}

TEST(DomeFile, NamesWhatIsWrong) {
    const auto elevation_error = [](const std::string& text, const ValueReader& reader = radiances) {
        return error_of([&] { parse_elevations(numbers(text), reader, false); });
    };
    const std::string ten = " (for angles 0, 10 .. 90 deg from the pole; or lines of an angle and a value)";
    EXPECT_EQ(elevation_error("1 2 3\n4\n"), "file:2: found 4 values where there should be 10" + ten);
    EXPECT_EQ(elevation_error("1 2 3 4 5 6 7 8 9 10 11"),
              "file:1:22: found 11 values where there should be 10" + ten);
    EXPECT_EQ(elevation_error("0 1\n30 2\n20 3\n"), "file:3:1: angle 20 deg does not come after 30 deg");
    EXPECT_EQ(elevation_error("0 1\n91 2\n"), "file:2:1: angle 91 deg is not within 0..90");
    EXPECT_EQ(elevation_error("0 1\n90 -2\n"), "file:2:4: negative radiance -2");
    EXPECT_EQ(error_of([&] { parse_elevations(numbers("0 1\n90 2\n"), radiances, true); }),
              "file:1:1: lines of an angle and a value have their order already");
    const Passband band = Passband::of_band(8, 12);
    EXPECT_EQ(elevation_error("0 0\n90 2\n", ValueReader(ValueUnit::kelvin, &band)),
              "file:1:3: temperature 0 K is not above 0 K");
    EXPECT_EQ(elevation_error("0 10\n90 -280\n", ValueReader(ValueUnit::celsius, &band)),
              "file:2:4: temperature -280 degrees C is not above -273.15 degrees C");
}

TEST(DomeFile, RefusesATableWithASeam) {
    std::string text = table_text(21);
    text.replace(text.rfind("103"), 3, "104");
    EXPECT_EQ(
        error_of([&] { parse_dome_table(numbers(text), radiances); }),
        "file:21:13: azimuth 360 deg has not azimuth 0's value at 30 deg from the pole (the last ten values "
        "repeat the first, or are left out)");
    EXPECT_EQ(error_of([&] { parse_dome_table(numbers("1 2\n"), radiances); }),
              "file:1: found 2 values where there should be 210 (ten from pole to horizon for each azimuth "
              "0, 18 .. "
              "360 deg; 200 without the last)");
}

}  // namespace
}  // namespace infra::ir
