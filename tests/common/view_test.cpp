#include "common/views/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_files.h"

namespace infra {
namespace {

using test::error_of;

View view_of(const std::string& options) {
    View view;
    parse_view(options, view);
    set_up_view(view);
    return view;
}

/// Origin, and direction times length, of the rays that RADIANCE 6.1's vwrays gives for three of the 3 x 3
/// pixels.
struct KnownView {
    const char* options;
    double rays[3][6];
};

constexpr const char* placement = " -vp 3 -1 2 -vd 1 2 -.5 -vu 0 .1 1 -vs .2 -vo 1.5 -va 9 ";

constexpr KnownView known_views[] = {
    {"-vtv -vh 60 -vv 35 -vl -.4",
     {{3.44367, .396898, 1.60108, 2.21837, 6.98449, -1.99460},
      {4.46241, -.176670, 1.34427, 7.31203, 4.11665, -3.27867},
      {3.92592, .00840411, 1.01159, 4.62959, 5.04202, -4.94206}}},
    {"-vtl -vh 6 -vv 3.5 -vl -.4",
     {{2.92295, .609530, 1.41015, 3.27327, 6.54654, -1.63663},
      {6.44767, -1.39338, .447951, 3.27327, 6.54654, -1.63663},
      {4.58495, -.768271, -.777053, 3.27327, 6.54654, -1.63663}}},
    {"-vtc -vh 200 -vv 70 -vl -.4",
     {{2.97252, .434786, 1.54147, -.137402, 7.17393, -2.29263},
      {4.05433, -2.18562, 1.33765, 5.27167, -5.92808, -3.31177},
      {4.27890, -.750610, .289668, 6.39448, 1.24695, -8.55166}}},
    {"-vth -vh 120 -vv 100 -vl -.1",
     {{3.31211, .451859, 2.21141, 1.56057, 7.25929, 1.05703},
      {4.46077, -1.19678, 1.72175, 7.30386, -.983919, -1.39123},
      {3.84332, -.574021, .834947, 4.21662, 2.12989, -5.82527}}},
    {"-vta -vh 240 -vv 200 -vl -.4",
     {{2.81245, .351260, 1.37636, -.937736, 6.75630, -3.11819},
      {2.96030, -2.49814, 1.93677, -.198522, -7.49070, -.316161},
      {2.55610, -2.40140, 1.70161, -2.21948, -7.00699, -1.49196}}},
    {"-vts -vh 240 -vv 200 -vl -.4",
     {{2.37586, .212133, 1.37455, -3.12070, 6.06066, -3.12724},
      {3.49559, -2.38900, 1.72602, 2.47797, -6.94500, -1.36991},
      {2.97925, -2.18130, 1.07582, -.103761, -5.90648, -4.62090}}},
};
constexpr double pixel_places[3][2] = {{1. / 6, 5. / 6}, {5. / 6, 1. / 2}, {1. / 2, 1. / 6}};

TEST(View, RaysAreVwraysRays) {
    for (const KnownView& known : known_views) {
        const View view = view_of(std::string(known.options) + placement);
        for (int k = 0; k < 3; ++k) {
            Vec3 origin, direction;
            double reach = 0;
            ASSERT_TRUE(view_ray(view, pixel_places[k][0], pixel_places[k][1], origin, direction, reach));
            EXPECT_NEAR(length(direction), 1, 1e-14);
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(origin[i], known.rays[k][i], 6e-6 * (1 + std::abs(known.rays[k][i])))
                    << known.options;
                const double end = known.rays[k][3 + i];
                EXPECT_NEAR(direction[i] * reach, end, 6e-6 * (1 + std::abs(end))) << known.options;
            }
        }
    }
}

TEST(View, LocateInvertsRays) {
    for (const KnownView& known : known_views) {
        const View view = view_of(std::string(known.options) + placement);
        for (double x = 0.05; x < 1; x += 0.15)
            for (double y = 0.05; y < 1; y += 0.15) {
                Vec3 origin, direction;
                double reach = 0;
                if (!view_ray(view, x, y, origin, direction, reach)) continue;
                const auto near = view_locate(view, origin + 2.5 * direction);
                ASSERT_TRUE(near) << known.options;
                EXPECT_NEAR(near->x, x, 1e-9) << known.options;
                EXPECT_NEAR(near->y, y, 1e-9) << known.options;
                EXPECT_NEAR(near->distance, 2.5, 1e-9) << known.options;
                EXPECT_FALSE(near->behind || near->beyond || near->outside) << known.options;
                EXPECT_TRUE(view_locate(view, origin + 1.01 * reach * direction)->beyond) << known.options;
            }
    }
}

TEST(View, LocateFlagsWhatIsNotSeen) {
    const View view = view_of("-vtv -vp 0 0 0 -vd 0 1 0 -vh 90 -vv 90 -vo 1");
    EXPECT_TRUE(view_locate(view, {0, -2, 0})->behind);
    EXPECT_TRUE(view_locate(view, {0, 0.5, 0})->behind);
    EXPECT_TRUE(view_locate(view, {3, 2, 0})->outside);
    EXPECT_FALSE(view_locate(view, {1, 0, 0}));
    EXPECT_FALSE(view_locate(view_of("-vtc"), {0, 0, 1}));
}

TEST(View, WithoutAftPlaneRaysHaveNoEnd) {
    Vec3 origin, direction;
    double reach = 0;
    EXPECT_TRUE(view_ray(view_of("-vtv"), 0.5, 0.5, origin, direction, reach));
    EXPECT_EQ(direction, Vec3(0, 1, 0));
    EXPECT_TRUE(std::isinf(reach));
}

TEST(View, FisheyesEndAtTheirCircle) {
    Vec3 origin, direction;
    double reach = 0;
    EXPECT_FALSE(view_ray(view_of("-vth -vh 180 -vv 180"), 0.01, 0.01, origin, direction, reach));
    EXPECT_FALSE(view_ray(view_of("-vta -vh 360 -vv 360"), 0.01, 0.01, origin, direction, reach));
    EXPECT_TRUE(view_ray(view_of("-vta -vh 180 -vv 180"), 0.01, 0.01, origin, direction, reach));
}

TEST(View, IllegalOnesAreRefusedInRadiancesWords) {
    const auto error = [](const std::string& options) { return error_of([&] { view_of(options); }); };
    EXPECT_EQ(error("-vd 0 0 0"), "zero view direction (see -vd)");
    EXPECT_EQ(error("-vu 0 0 0"), "zero view up vector (see -vu)");
    EXPECT_EQ(error("-vd 0 0 1"), "view up parallel to view direction (see -vu and -vd)");
    EXPECT_EQ(
        error("-vo -1"),
        "illegal fore/aft clipping plane (-vo must not be negative, -va must be 0 or greater than -vo)");
    EXPECT_EQ(error("-vo 3 -va 2").substr(0, 31), "illegal fore/aft clipping plane");
    for (const char* options : {"-vh 0", "-vh -5", "-vtv -vh 180", "-vtc -vh 361", "-vta -vh 361",
                                "-vth -vh 181", "-vts -vh 360", "-vtl -vh 0"})
        EXPECT_EQ(error(options), "illegal horizontal view size (see -vh)") << options;
    for (const char* options :
         {"-vv 0", "-vtv -vv 180", "-vtc -vv 180", "-vta -vv 361", "-vth -vv 181", "-vts -vv 360"})
        EXPECT_EQ(error(options), "illegal vertical view size (see -vv)") << options;
    EXPECT_EQ(error("-vtl -vh 1e5 -vv 1e5"), "no error");
    EXPECT_EQ(error("-vtc -vh 360"), "no error");
}

TEST(View, SettingUpTwiceChangesNothing) {
    View view = view_of("-vtv -vd 0 3 4 -vu 0 1 1");
    EXPECT_DOUBLE_EQ(view.distance, 5);
    const Vec3 axis = view.image_x;
    set_up_view(view);
    EXPECT_DOUBLE_EQ(view.distance, 5);
    EXPECT_LT(length(view.image_x - axis), 1e-15);
}

TEST(View, ResolutionFitsTheView) {
    const auto fit = [](double aspect, double pixel_aspect, int x, int y) {
        fit_resolution(aspect, pixel_aspect, x, y);
        return std::tuple(pixel_aspect, x, y);
    };
    EXPECT_EQ(fit(1, 1, 16, 12), std::tuple(1.0, 12, 12));
    EXPECT_EQ(fit(1, 0, 16, 12), std::tuple(16. / 12, 16, 12));
    EXPECT_EQ(fit(0.5, 1, 512, 512), std::tuple(1.0, 512, 256));
    EXPECT_EQ(fit(1, 2, 100, 100), std::tuple(2.0, 100, 50));
    EXPECT_EQ(fit(1e-6, 1, 100, 100), std::tuple(1.0, 100, 1));
    EXPECT_NEAR(view_aspect(view_of("-vtv -vh 90 -vv 45")), std::tan(M_PI / 8), 1e-12);
    EXPECT_NEAR(view_aspect(view_of("-vtl -vh 4 -vv 3")), 0.75, 1e-12);
}

TEST(View, CropSeesTheSameRays) {
    for (const char* type :
         {"-vtv -vh 70 -vv 50", "-vtl", "-vtc -vh 200 -vv 60", "-vth -vh 90 -vv 90", "-vta", "-vts"}) {
        const View whole = view_of(std::string(type) + " -vs .1 -vl -.05");
        View part = whole;
        crop_view(part, 0.25, 0.6, 0.75, 0.2);
        Vec3 origin, direction, part_origin, part_direction;
        double reach = 0;
        ASSERT_TRUE(view_ray(whole, 0.25 + 0.5 * 0.3, 0.2 + 0.4 * 0.9, origin, direction, reach));
        ASSERT_TRUE(view_ray(part, 0.3, 0.9, part_origin, part_direction, reach));
        EXPECT_LT(length(direction - part_direction), 1e-12) << type;
        EXPECT_LT(length(origin - part_origin), 1e-9) << type;
    }
    View view = view_of("-vtv");
    EXPECT_EQ(error_of([&] { crop_view(view, 0.5, 0, 0.5, 1); }), "zero crop area");
}

}  // namespace
}  // namespace infra
