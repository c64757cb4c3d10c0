#include <gtest/gtest.h>

#include <numbers>

#include "rt/lobes/table.h"
#include "scene_pieces.h"
#include "support/chi_square.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::degree;
constexpr double view_angles[] = {15, 50, 80};

struct Draw {
    Vec3 wi;
    double weight, pdf;
};

struct Frame {
    Vec3 normal, u, v;
    explicit Frame(const Vec3& n) : normal(n) { make_frame(n, u, v); }
    Vec3 to_scene(const Vec3& d) const { return u * d.x + v * d.y + normal * d.z; }
    Vec3 to_local(const Vec3& d) const { return {dot(d, u), dot(d, v), dot(d, normal)}; }
};

// A surface that lies askew; the directions of the tests are local to it.
const Frame frame(normalize(Vec3{0.3, -0.5, 0.7}));

TEST(TableLobe, SamplesFollowPdfAndCarryEval) {
    const test::TemporaryFolder folder;
    const auto tables = test::write_tables(folder);
    const double level = test::sidak_level(1e-3, static_cast<int>(tables.size() * std::size(view_angles)));
    std::uint64_t number = 0;
    for (const auto& file : tables)
        for (const double view : view_angles) {
            SCOPED_TRACE(file.name + ", viewer at " + std::to_string(view) + " deg");
            const LobeSampler sampler(std::make_shared<const TableDistribution>(file.table), 0.2);
            const double albedo = file.table->lobe_reflectance_dh(std::cos(view * degree));
            const TableLobe lobe(Spectrum(3, static_cast<float>(albedo)), albedo, sampler, nullptr,
                                 frame.normal, frame.normal,
                                 frame.to_scene(test::direction(view * degree, 1.1)), 1);
            RandomStream random(5, ++number);
            const auto pdf = [&](const Vec3& wi) { return lobe.pdf(frame.to_scene(wi)); };
            test::ChiSquareOptions options;
            options.samples = 300'000;
            const auto result = test::chi_square_test(
                [&](double, double, double) {
                    const LobeDraw draw = lobe.sample(random, 0, 1);
                    return Draw{frame.to_local(draw.wi), draw.weight,
                                draw.weight > 0 ? lobe.pdf(draw.wi) : 0};
                },
                [&](const Vec3& wi) { return lobe.eval(frame.to_scene(wi), 0) > 0 ? pdf(wi) : 0; }, options);
            EXPECT_EQ(result.fault, "");
            EXPECT_GT(result.p, level) << "chi-square " << result.statistic << " of " << result.degrees;
            EXPECT_LE(result.integral, 1 + 1e-5);
            EXPECT_NEAR(result.mean_weight, 1, 4 * result.weight_error);  // the albedo is in the coefficient
            EXPECT_NEAR(static_cast<double>(lobe.coefficient[0]), albedo, 1e-6);
            for (int n = 0; n < 2000; ++n) {
                const LobeDraw draw = lobe.sample(random, 0, 1);
                if (draw.weight <= 0) continue;
                EXPECT_NEAR(draw.weight * lobe.pdf(draw.wi) / lobe.eval(draw.wi, 0), 1, 1e-5);
            }
        }
}

TEST(TableLobe, IsReciprocalWhereTheTableIs) {
    const test::TemporaryFolder folder;
    RandomStream random(6, 1);
    for (const auto& file : test::write_tables(folder)) {
        double largest = 0;
        for (int n = 0; n < 500; ++n) {
            const auto draw = [&] {
                return test::direction(88 * degree * random.uniform(),
                                       2 * std::numbers::pi * random.uniform());
            };
            const Vec3 a = draw(), b = draw();
            const double ab = file.table->eval_lobe(a, b), ba = file.table->eval_lobe(b, a);
            largest = std::max(largest, std::fabs(ab - ba) / std::max({ab, ba, 1e-3}));
        }
        if (file.reciprocal)
            EXPECT_LT(largest, 1e-5) << file.name;
        else
            EXPECT_GT(largest, 0.1) << file.name << " is there to show that the test can tell";
    }
}

TEST(TableLobe, SampleCountFollowsTheWeightOfTheRay) {
    const test::TemporaryFolder folder;
    const auto file = test::write_tables(folder).front();
    const LobeSampler sampler(std::make_shared<const TableDistribution>(file.table), 0.2);
    const TableLobe lobe(Spectrum(3, 0.5f), 0.5, sampler, nullptr, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 64);
    EXPECT_EQ(lobe.sample_count(1), 64);
    EXPECT_EQ(lobe.sample_count(0.25), 16);
    EXPECT_EQ(lobe.sample_count(1e-4), 1);
}

}  // namespace
}  // namespace infra
