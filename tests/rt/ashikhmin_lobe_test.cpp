#include <gtest/gtest.h>

#include "lobe_statistics.h"
#include "rt/lobes/ashikhmin.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::degree;
constexpr double view_angles[] = {0, 40, 75};
constexpr double powers[][2] = {{0, 0}, {5, 60}, {200, 200}, {800, 20}};
constexpr int case_count = static_cast<int>(std::size(view_angles) * std::size(powers));

AshikhminReflection lobe_of(const Vec3& to_viewer, const double (&power)[2]) {
    SurfaceFrame frame;
    frame_along({0.8, 0.6, 0}, {0, 0, 1}, frame);
    return {Spectrum(3, 1), AshikhminSetting{-to_viewer, frame, {0, 0, 1}, power[0], power[1], 1}};
}

template <class Body>
void for_all_cases(const Body& body) {
    std::uint64_t number = 0;
    for (const double view : view_angles)
        for (const auto& power : powers) {
            SCOPED_TRACE("viewer at " + std::to_string(view) + " deg, powers " + std::to_string(power[0]) +
                         " and " + std::to_string(power[1]));
            body(lobe_of(test::direction(view * degree, 0.7), power), ++number);
        }
}

TEST(AshikhminReflection, SamplesFollowPdfAndWeighOne) {
    const double level = test::sidak_level(1e-3, case_count);
    for_all_cases([&](const AshikhminReflection& lobe, std::uint64_t number) {
        const auto result = test::sample_lobe(
            lobe, 1, [&](const Vec3& wi) { return lobe.pdf(wi); }, false, number);
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
        EXPECT_LE(result.integral, 1 + 1e-5);
        EXPECT_NEAR(result.mean_weight, result.integral, 4 * result.weight_error + 1e-5);
        EXPECT_EQ(lobe.mean_weight(1), 1);
    });
}

TEST(AshikhminReflection, ReflectsNoMoreThanItGets) {
    for_all_cases([&](const AshikhminReflection& lobe, std::uint64_t) {
        EXPECT_LE(test::hemisphere_integral([&](const Vec3& wi) { return lobe.eval(wi, 0); }, 1), 1 + 1e-5);
    });
}

TEST(AshikhminReflection, IsReciprocal) {
    RandomStream random(3, 3);
    for (const auto& power : powers)
        for (int n = 0; n < 1000; ++n) {
            const auto draw = [&] {
                return test::direction(85 * degree * random.uniform(),
                                       2 * std::numbers::pi * random.uniform());
            };
            const Vec3 a = draw(), b = draw();
            const double ab = lobe_of(a, power).eval(b, 0) / b.z, ba = lobe_of(b, power).eval(a, 0) / a.z;
            EXPECT_NEAR(ab, ba, 1e-5 * std::max(ab, ba) + 1e-4 * same_place);
        }
}

TEST(AshikhminReflection, IsSharperAlongTheLargerPower) {
    const AshikhminReflection lobe = lobe_of({0, 0, 1}, {20, 500});
    const double angle = 10 * degree;
    const Vec3 along = Vec3{0.8, 0.6, 0} * std::sin(angle) + Vec3{0, 0, 1} * std::cos(angle);
    const Vec3 across = Vec3{-0.6, 0.8, 0} * std::sin(angle) + Vec3{0, 0, 1} * std::cos(angle);
    EXPECT_NEAR(lobe.eval(along, 0) / lobe.eval(across, 0), std::pow(std::cos(angle / 2), 20 - 500), 1e-6);
}

}  // namespace
}  // namespace infra
