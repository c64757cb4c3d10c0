// The sun's disk and the air of a path, in closed forms.
#include "common/planck/planck.h"
#include "fixtures.h"
#include "ir/genirsky/air.h"
#include "ir/genirsky/atmosphere.h"
#include "ir/genirsky/frame.h"
#include "ir/genirsky/sun.h"

namespace infra::ir {
namespace {

using test::error_of;

TEST(Sun, HasItsIrradiance) {  // VALIDATION V14
    const Sun sun;
    EXPECT_NEAR(sun.solid_angle(), 6.802e-5, 1e-8);
    EXPECT_NEAR(sun.solid_angle() * sun.radiance(Passband::of_band(3, 5)), 21.842, 1e-3);
    EXPECT_NEAR(sun.solid_angle() * sun.radiance(Passband::of_band(8, 12)), 1.2995, 1e-4);
}

TEST(Frame, AzimuthIsClockwiseFromX) {
    const auto near = [](const Vec3& a, const Vec3& b) { return length(a - b) < 1e-12; };
    EXPECT_TRUE(near(Frame{}.direction(0, 0), {1, 0, 0}));
    EXPECT_TRUE(near(Frame{}.direction(0, 90), {0, -1, 0}));
    EXPECT_TRUE(near(Frame{}.direction(90, 17), {0, 0, 1}));
    EXPECT_TRUE(near((Frame{.turn_deg = 90}).direction(0, 0), {0, 1, 0}));   // a compass: north is +y
    EXPECT_TRUE(near((Frame{.turn_deg = 90}).direction(0, 90), {1, 0, 0}));  // and east +x
    EXPECT_TRUE(near((Frame{.y_up = true}).direction(0, 90), {0, 0, 1}));
    EXPECT_TRUE(near((Frame{.y_up = true}).direction(90, 0), {0, 1, 0}));
}

TEST(Air, HomogeneousAirIsExact) {
    const std::vector<Passband> bands{Passband::of_band(8, 10), Passband::of_band(10, 12)};
    const AirRow row = homogeneous_air(288.15, 2e-4, 500, bands);
    EXPECT_NEAR(row.values[0].transmittance, std::exp(-.1), 1e-15);
    EXPECT_NEAR(row.values[1].radiance, (1 - std::exp(-.1)) * band_radiance(288.15, 10, 12), 1e-12);
}

TEST(Air, ComesFromRuns) {
    const double extinction = 3e-4;
    std::string text;
    for (const double range : {500., 1000., 4000.})
        text += test::tape7_run(
            {.temperature = 288.15, .transmittance = std::exp(-extinction * range), .background = 300});
    Request request;
    request.ranges_m = {500, 1000, 4000};
    request.passbands = {Passband::of_band(8, 12)};
    const auto rows = air_of_runs(parse_tape7(text, "tape7"), request);
    ASSERT_EQ(rows.size(), 3u);
    for (const AirRow& row : rows) {
        const AirRow exact = homogeneous_air(288.15, extinction, row.distance, request.passbands);
        EXPECT_NEAR(row.values[0].transmittance, exact.values[0].transmittance, 1e-8);
        EXPECT_NEAR(row.values[0].radiance, exact.values[0].radiance, 1e-5 * exact.values[0].radiance);
    }
}

TEST(Air, RefusesRowsOutOfOrder) {
    EXPECT_EQ(
        error_of([] {
            check_air({{100, {{.9, 1}}}, {200, {{.95, 2}}}});
        }),
        "transmittance grows from 0.9 at 100 m to 0.95 at 200 m (are the ranges in the order of the runs?)");
    EXPECT_EQ(error_of([] {
                  check_air({{100, {{.9, 1}}}, {100, {{.8, 2}}}});
              }),
              "range 100 m does not come after 100 m");
}

TEST(Air, WritesBandsAndRows) {
    const std::vector<Passband> bands{Passband::of_band(8, 10), Passband::of_band(10, 12)};
    EXPECT_EQ(air_text({{100, {{.5, 1}, {.25, 2}}}, {200, {{0, 3}, {.125, 4}}}}, bands),
              "#% bands 8 10 12\n100  0.5 1  0.25 2\n200  1e-30 3  0.125 4\n");
}

}  // namespace
}  // namespace infra::ir
