#include "rt/programs/value_writer.h"

#include <gtest/gtest.h>

#include <cstring>

namespace infra {
namespace {

const ValueConverter colors;

TEST(ValueWriter, writes_text_with_a_tab_after_each_value) {
    std::string out;
    ValueWriter writer(NumberFormat::text, colors, out);
    writer.indent(2);
    writer.real(1e10);
    writer.vector({0, -1.5, 2});
    writer.radiance(Spectrum(3, 0.25f));
    writer.name("wall");
    writer.end_of_ray();
    EXPECT_EQ(out,
              "\t\t1.000000e+10\t0.000000e+00\t-1.500000e+00\t2.000000e+00\t"
              "2.500000e-01\t2.500000e-01\t2.500000e-01\twall\t\n");
}

TEST(ValueWriter, writes_raw_numbers_without_line_ends) {
    std::string floats, doubles;
    ValueWriter(NumberFormat::floats, colors, floats).vector({1, 2, 3.5});
    ValueWriter(NumberFormat::floats, colors, floats).end_of_ray();
    ValueWriter(NumberFormat::doubles, colors, doubles).real(0.1);
    const float expected[] = {1, 2, 3.5f};
    ASSERT_EQ(floats.size(), sizeof expected);
    EXPECT_EQ(std::memcmp(floats.data(), expected, sizeof expected), 0);
    const double tenth = 0.1;
    ASSERT_EQ(doubles.size(), sizeof tenth);
    EXPECT_EQ(std::memcmp(doubles.data(), &tenth, sizeof tenth), 0);
}

TEST(ValueWriter, writes_colors_as_pixels) {
    std::string out;
    ValueWriter(NumberFormat::color, colors, out).radiance(Spectrum(3, 1.0f));
    // 1 = 128/256 * 2^1, the exponent is kept with 128 added.
    EXPECT_EQ(out, std::string("\x80\x80\x80\x81"));
}

}  // namespace
}  // namespace infra
