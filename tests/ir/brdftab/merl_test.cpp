// The MERL reader, on synthetic files of the full size that the format prescribes.
#include "ir/brdftab/merl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include "common/error.h"
#include "nrlbrdf/half_vector.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::degree;
using test::pi;

constexpr double scales[] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

/// A file whose cells hold value(channel, theta_h, theta_d, phi_d) [1/sr] at their centres.
std::string merl_file(const std::function<double(int, double, double, double)>& value) {
    const std::int32_t counts[3] = {90, 90, 180};
    std::string bytes(reinterpret_cast<const char*>(counts), sizeof counts);
    for (int channel = 0; channel < 3; ++channel)
        for (int h = 0; h < 90; ++h)
            for (int d = 0; d < 90; ++d)
                for (int p = 0; p < 180; ++p) {
                    const double share = (h + 0.5) / 90;
                    const double raw = value(channel, share * share * pi / 2, (d + 0.5) / 90 * pi / 2,
                                             (p + 0.5) / 180 * pi) /
                                       scales[channel];
                    bytes.append(reinterpret_cast<const char*>(&raw), sizeof raw);
                }
    return bytes;
}

std::string error_of(const std::string& bytes) {
    try {
        MerlTable(bytes, MerlChannel::red, "x.binary");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(MerlTable, ChoosesAChannel) {
    const std::string bytes =
        merl_file([](int channel, double, double, double) { return (channel + 1) * 0.1; });
    const double expected[] = {0.1, 0.2, 0.3, 0.2};
    for (const MerlChannel channel :
         {MerlChannel::red, MerlChannel::green, MerlChannel::blue, MerlChannel::mean}) {
        const MerlTable table(bytes, channel, "x.binary");
        EXPECT_EQ(table.filled(), 0u);
        for (int i = 0; i <= 90; i += 15)
            for (int r = 0; r <= 90; r += 15)
                EXPECT_NEAR(table(i * degree, 1.3, r * degree), expected[static_cast<int>(channel)], 1e-7);
    }
}

TEST(MerlTable, PutsValuesAtTheirAngles) {
    const auto f = [](double theta_h, double theta_d, double phi_d) {
        return 0.1 + 0.3 * std::exp(-10 * theta_h) + 0.1 * theta_d * theta_d + 0.05 * std::cos(2 * phi_d);
    };
    const MerlTable table(merl_file([f](int, double h, double d, double p) { return f(h, d, p); }),
                          MerlChannel::green, "x.binary");
    for (int i = 5; i <= 80; i += 15)
        for (int phi = 0; phi < 360; phi += 24)
            for (int r = 10; r <= 80; r += 15) {
                const HalfVector half = half_vector(i * degree, phi * degree, r * degree);
                EXPECT_NEAR(table(i * degree, phi * degree, r * degree),
                            f(half.theta_h, half.theta_d, half.phi_d), 3e-4);
            }
}

TEST(MerlTable, IsReciprocal) {
    const MerlTable table(
        merl_file([](int, double h, double d, double p) { return 1 + h + d * std::sin(p); }),
        MerlChannel::red, "x.binary");
    for (int i = 0; i <= 90; i += 10)
        for (int r = 0; r <= 90; r += 10)
            EXPECT_NEAR(table(i * degree, 2.2, r * degree), table(r * degree, 2.2, i * degree), 1e-6);
}

TEST(MerlTable, FillsCellsThatWereNotMeasured) {
    // Real files lack grazing cells.
    const MerlTable table(merl_file([](int, double, double d, double) { return d > 1.4 ? -1 : 0.2; }),
                          MerlChannel::red, "x.binary");
    EXPECT_GT(table.filled(), 0u);
    EXPECT_NEAR(table(89 * degree, pi, 89 * degree), 0.2, 1e-7);
}

TEST(MerlTable, RefusesWhatIsNoMerlFile) {
    EXPECT_EQ(error_of(""), "x.binary: the file is empty");
    EXPECT_EQ(error_of("abc"), "x.binary: too short for a MERL table");
    std::string bytes = merl_file([](int, double, double, double) { return 0.1; });
    EXPECT_EQ(error_of(bytes.substr(0, 100)), "x.binary: found 100 bytes where a MERL table has 34992012");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::memcpy(bytes.data() + 12 + 80, &nan, sizeof nan);
    EXPECT_EQ(error_of(bytes), "x.binary: value 10 of channel 0 is not finite");
    bytes[0] = 91;
    EXPECT_EQ(error_of(bytes), "x.binary: not a MERL table: counts 91 90 180 (90 90 180 are expected)");
    EXPECT_NE(error_of(merl_file([](int, double, double, double) { return -1; })).find("no measured value"),
              std::string::npos);
}

}  // namespace
}  // namespace infra::ir
