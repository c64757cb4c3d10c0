// What tables of matrices and trees answer: values, totals, samples.
#include <gtest/gtest.h>

#include <numbers>

#include "bsdf/bsdf.h"
#include "bsdf_text.h"
#include "support/chi_square.h"

namespace infra {
namespace {

using std::numbers::pi;
using test::disk_lobe;

Bsdf const& loaded(const std::string& text) {
    static std::vector<std::shared_ptr<const Bsdf>> kept;
    kept.push_back(parse_bsdf(text, "test.xml").bsdf);
    return *kept.back();
}

std::vector<std::string> lobe_files() {
    const auto reflection = disk_lobe(0.02, 0.8, 0.1), transmission = disk_lobe(0, 0.6, 0.2);
    return {test::matrix_file(reflection, transmission), test::tree_file(3, reflection, transmission),
            test::tree_file(4, reflection, transmission)};
}

Vec3 direction(double theta, double azimuth) {
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

TEST(BsdfTable, OfAConstantIsLambertian) {
    const auto constant = disk_lobe(0.1, 0, 1);
    for (const std::string& text :
         {test::matrix_file(constant, constant), test::tree_file(3, constant, constant),
          test::tree_file(4, constant, constant)}) {
        const Bsdf& bsdf = loaded(text);
        EXPECT_EQ(bsdf.reflection(true), nullptr);
        EXPECT_EQ(bsdf.transmission(false), nullptr);
        EXPECT_NEAR(bsdf.lambertian_reflectance(true).y, 0.1 * pi, 1e-6);
        EXPECT_EQ(bsdf.lambertian_reflectance(false).y, 0);
        EXPECT_NEAR(bsdf.lambertian_transmittance(true).y, 0.1 * pi, 1e-6);
        EXPECT_NEAR(bsdf.lambertian_transmittance(false).y, 0.1 * pi, 1e-6);
        EXPECT_NEAR(bsdf.resolution({0, 0, 1}).least, pi, 1e-9);
    }
}

TEST(BsdfTable, PeaksWhereLightIsHeading) {
    for (const std::string& text : lobe_files()) {
        const Bsdf& bsdf = loaded(text);
        const Vec3 in = direction(0.6, 0.3);
        const Vec3 mirror{-in.x, -in.y, in.z}, straight = -in;
        EXPECT_GT(bsdf.reflection(true)->entry(in, mirror).value, 0.5);
        EXPECT_LT(bsdf.reflection(true)->entry(in, in).value, 0.05);
        EXPECT_GT(bsdf.transmission(true)->entry(in, straight).value, 0.4);
        EXPECT_EQ(bsdf.reflection(true)->entry(in, straight).cell, ScatterEntry::none);
    }
}

TEST(BsdfTable, OfOneWayTransmissionIsReciprocal) {
    for (const std::string& text : lobe_files()) {
        const Bsdf& bsdf = loaded(text);
        ASSERT_EQ(bsdf.transmission(true), bsdf.transmission(false));
        const Vec3 a = direction(0.4, 1), b = -direction(0.7, 1.2);
        const double value = bsdf.transmission(true)->entry(a, b).value;
        EXPECT_GT(value, 0);
        EXPECT_EQ(value, bsdf.transmission(false)->entry(b, a).value);
    }
}

struct Sample {
    Vec3 wi;
    double weight, pdf;
};

// In coordinates whose z is the side that is sampled.
void check_sampler(const ScatterTable& table, const Vec3& in, const std::string& what) {
    SCOPED_TRACE(what);
    const double total = table.total(in);
    ASSERT_GT(total, 0);
    const bool to_front = (in.z > 0) != table.sides().transmits;
    const auto turned = [&](const Vec3& d) { return Vec3{d.x, d.y, to_front ? d.z : -d.z}; };
    const auto pdf = [&](const Vec3& d) { return table.entry(in, turned(d)).value * std::fabs(d.z) / total; };
    test::ChiSquareOptions options{.samples = 60'000, .integral_tolerance = 2e-5};
    const auto result = test::chi_square_test(
        [&](double u1, double u2, double u3) {
            const Vec3 wi = turned(table.sample(in, u1, u2, u3));
            return Sample{wi, 1, pdf(wi)};
        },
        pdf, options);
    EXPECT_NEAR(result.integral, 1, 2e-3);
    EXPECT_GT(result.p, 1e-4);
    for (const char* fault : {"not of unit length", "hits in a cell"})
        EXPECT_EQ(result.fault.find(fault), std::string::npos) << result.fault;
}

TEST(BsdfTable, SamplesByItsValues) {
    int number = 0;
    for (const std::string& text : lobe_files()) {
        const Bsdf& bsdf = loaded(text);
        const std::string name = "file " + std::to_string(number++);
        const Vec3 in = direction(0.8, 2);
        check_sampler(*bsdf.reflection(true), in, name + ", reflection");
        check_sampler(*bsdf.transmission(true), in, name + ", transmission");
        if (number != 2)  // a tree of rank 3 is not sampled by reciprocity
            check_sampler(*bsdf.transmission(false), -in, name + ", transmission from behind");
    }
}

TEST(BsdfTable, IsLargestWhereItSaysSo) {
    for (const std::string& text : lobe_files()) {
        const ScatterTable& table = *loaded(text).reflection(true);
        double largest = 0;
        for (double theta = 0.01; theta < 1.57; theta += 0.01)
            for (double azimuth = 0; azimuth < 6.2; azimuth += 0.2)
                largest = std::max(largest, table.total(direction(theta, azimuth)));
        EXPECT_LE(largest, table.largest_total() * (1 + 1e-6));
        EXPECT_GE(largest, table.largest_total() * 0.98);
    }
}

}  // namespace
}  // namespace infra
