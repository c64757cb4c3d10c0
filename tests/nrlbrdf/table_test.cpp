#include "nrlbrdf/table.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "common/test_files.h"
#include "nrlbrdf/models.h"
#include "nrlbrdf/table_file.h"
#include "tables.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

double polar(int node, int count) { return pi / 2 * node / (count - 1); }

TEST(Table, IsExactAtEveryNode) {
    const BrdfGrid grid = tabulate(phong_lobe(0.3, 0.4, 8), {9, 12, 7});
    const BrdfTable table(grid);
    auto value = grid.values.begin();
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 12; ++k)
            for (int j = 0; j < 7; ++j, ++value) {
                const Vec3 wi = test::direction(polar(i, 9), 0.7);
                const Vec3 wo = test::direction(polar(j, 7), 0.7 + 2 * pi * k / 12);
                if (i > 0 && j > 0) {
                    EXPECT_NEAR(table.eval(wo, wi), *value, 1e-13);
                }
                EXPECT_NEAR(table.diffuse_reflectance() / pi +
                                table.eval_lobe(polar(i, 9), 2 * pi * k / 12, polar(j, 7)),
                            *value, 1e-14);
            }
}

TEST(Table, IsContinuousAcrossCellsSeamAndHorizon) {
    constexpr double step = 1e-7;
    for (const auto& [name, table] : test::three_tables()) {
        std::mt19937_64 engine(3);
        std::uniform_real_distribution<double> uniform;
        for (int n = 0; n < 2000; ++n) {
            const int node = static_cast<int>(uniform(engine) * table->theta_i_count());
            const double at_node = polar(node, table->theta_i_count());
            const double theta = uniform(engine) * pi / 2, phi = uniform(engine) * 2 * pi;
            const double steepest = 100;  // [1/sr per radian], above every slope of the three
            const auto f = [&](double i, double k, double j) { return table->eval_lobe(i, k, j); };
            EXPECT_NEAR(f(at_node - step, phi, theta), f(at_node + step, phi, theta), steepest * step)
                << name;
            EXPECT_NEAR(f(theta, phi, at_node - step), f(theta, phi, at_node + step), steepest * step)
                << name;
            const double row = 2 * pi * std::floor(uniform(engine) * table->phi_count()) / table->phi_count();
            EXPECT_NEAR(f(theta, row - step, theta), f(theta, row + step, theta), steepest * step) << name;
            EXPECT_NEAR(f(theta, -step, theta), f(theta, 2 * pi - step, theta), 1e-12) << name;
        }
    }
}

TEST(Table, TakesTheViewerAsTheReflectedDirection) {
    // f depends on each angle in its own way, so that any mix-up of directions or of the sense of phi shows.
    const BrdfFunction f = [](double theta_i, double phi, double theta_r) {
        return 1 + theta_i + 3 * theta_r + 0.5 * std::sin(phi);
    };
    const BrdfTable table(tabulate(f, {31, 360, 31}));
    for (const double phi : {0.2, 1.0, 2.5, 4.0, 6.0})
        EXPECT_NEAR(table.eval(test::direction(0.3, 1.1 + phi), test::direction(0.9, 1.1)), f(0.9, phi, 0.3),
                    1e-4);
    EXPECT_EQ(table.eval({0, 0.6, -0.8}, {0, 0, 1}), 0);
    EXPECT_EQ(table.eval({0, 0, 1}, {0, 0.6, -0.8}), 0);
}

TEST(Table, SplitsOffTheLargestConstant) {
    for (const auto& [name, table] : test::three_tables()) {
        double least = 1e30;
        for (int i = 0; i < table->theta_i_count(); ++i)
            for (int k = 0; k < table->phi_count(); ++k)
                for (int j = 0; j < table->theta_r_count(); ++j) {
                    EXPECT_GE(table->lobe_node(i, k, j), 0) << name;
                    least = std::min(least, table->lobe_node(i, k, j));
                }
        EXPECT_EQ(least, 0) << name;
    }
    const BrdfTable flat(tabulate(lambertian(0.4)));
    EXPECT_TRUE(flat.lobe_is_zero());
    EXPECT_NEAR(flat.diffuse_reflectance(), 0.4, 1e-7);
    EXPECT_NEAR(flat.reflectance_dh(0.3), 0.4, 1e-7);
}

TEST(Table, ModelsAreReciprocal) {
    for (const BrdfFunction& f : {gaussian_lobe(0.2, 0.5, 0.25), phong_lobe(0.3, 0.4, 8)}) {
        const BrdfTable table(tabulate(f, {25, 24, 25}));
        std::mt19937_64 engine(5);
        std::uniform_real_distribution<double> uniform;
        for (int n = 0; n < 1000; ++n) {
            const Vec3 a = test::direction(uniform(engine) * pi / 2, uniform(engine) * 2 * pi);
            const Vec3 b = test::direction(uniform(engine) * pi / 2, uniform(engine) * 2 * pi);
            EXPECT_NEAR(table.eval(a, b), table.eval(b, a), 1e-5 * table.eval(a, b));
        }
    }
}

TEST(Table, ReflectanceIsTheIntegralOfWhatEvalGives) {
    // Midpoints within every cell of theta_i, so that the only error is the curve of cos sin: O(n^-2).
    for (const auto& [name, table] : test::three_tables())
        for (const double theta_r : {0.0, 0.4, 1.1, 1.5}) {
            const int n = (table->theta_i_count() - 1) * 40, m = table->phi_count() * 2;
            double sum = 0;
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < m; ++b) {
                    const double theta = (a + 0.5) * pi / 2 / n, phi = (b + 0.5) * 2 * pi / m;
                    const Vec3 wo = test::direction(theta_r, 0);
                    sum += table->eval(wo, test::direction(theta, -phi)) * std::cos(theta) * std::sin(theta);
                }
            const double integral = sum * (pi / 2 / n) * (2 * pi / m);
            EXPECT_NEAR(table->reflectance_dh(std::cos(theta_r)), integral, 2e-5)
                << name << " at " << theta_r;
        }
}

TEST(Table, ReflectanceOfTheModels) {
    // Directional-hemispherical reflectance of the Phong lobe at the normal: specular, by its normalisation
    // there.
    const BrdfTable phong(tabulate(phong_lobe(0.3, 0.4, 8), {91, 90, 91}));
    EXPECT_NEAR(phong.reflectance_dh(1), 0.7, 1e-3);
    for (const auto& [name, table] : test::three_tables())
        for (int j = 0; j < table->theta_r_count(); ++j)
            EXPECT_LE(table->diffuse_reflectance() + table->lobe_reflectance_node(j), 1) << name;
    // Reciprocal: what leaves towards a viewer equals what is reflected from that angle.
    const BrdfTable gaussian(tabulate(gaussian_lobe(0.2, 0.5, 0.25), {46, 72, 46}));
    for (int n = 0; n < 46; ++n)
        EXPECT_NEAR(gaussian.incident_reflectance(n), gaussian.reflectance_dh(std::cos(polar(n, 46))), 1e-6);
}

TEST(Table, PhiAndMirrorDirectivesAreTheSameBrdf) {
    // One BRDF, symmetric in phi, written in the four ways.
    const auto f = [](int i, double phi_deg, int j) {
        return 0.1 + 0.01 * i + 0.02 * j + 0.05 * std::cos((phi_deg - 180) * pi / 180);
    };
    const auto text = [&](bool half, bool mirror_zero) {
        std::string s = std::string(half ? "#% phi 180\n" : "") + (mirror_zero ? "#% mirror 0\n" : "");
        s += std::string("3 ") + (half ? "5" : "8") + " 4\n0\n";
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < (half ? 5 : 8); ++k)
                for (int j = 0; j < 4; ++j)
                    s += std::to_string(f(i, 45 * k + (mirror_zero ? 180 : 0), j)) + " ";
        return s;
    };
    const BrdfTable plain(parse_table(text(false, false), "plain"));
    for (const auto& [half, mirror] : {std::pair{true, false}, {false, true}, {true, true}}) {
        const BrdfTable other(parse_table(text(half, mirror), "other"));
        std::mt19937_64 engine(5);
        std::uniform_real_distribution<double> uniform;
        for (int n = 0; n < 500; ++n) {
            const Vec3 a = test::direction(uniform(engine) * pi / 2, uniform(engine) * 2 * pi);
            const Vec3 b = test::direction(uniform(engine) * pi / 2, uniform(engine) * 2 * pi);
            EXPECT_NEAR(plain.eval(a, b), other.eval(a, b), 1e-12) << half << mirror;
        }
        EXPECT_NEAR(plain.reflectance_dh(0.5), other.reflectance_dh(0.5), 1e-7);
    }
}

TEST(PanelTable, ReflectsOneAtEveryAngleAndItsLobeStaysOnTheMirrorSide) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "panel.brdf";
    ASSERT_EQ(
        std::system(("python3 " INFRA_SOURCE_DIR "/scenes/validation/panels/make_brdf.py " + path).c_str()),
        0);
    const LoadedTable loaded = load_table(path);
    EXPECT_TRUE(loaded.warnings.empty());
    const BrdfTable& table = *loaded.table;
    EXPECT_NEAR(table.diffuse_reflectance(), 0.86, 1e-7);
    for (double theta = 0; theta < pi / 2; theta += 0.01)
        EXPECT_NEAR(table.reflectance_dh(std::cos(theta)), 1, 1e-6);
    for (int i = 0; i < table.theta_i_count(); ++i) EXPECT_NEAR(table.incident_reflectance(i), 1, 1e-6);
    // Seen 30 deg from the normal: nothing on the viewer's side of the horizon.
    for (double theta = 0; theta <= pi / 2; theta += 0.01)
        for (double phi = -pi / 2; phi <= pi / 2; phi += 0.01)
            EXPECT_NEAR(table.eval_lobe(theta, phi, pi / 6), 0, 1e-12);
    EXPECT_GT(table.eval_lobe(pi / 6, pi, pi / 6), 0.3);
}

}  // namespace
}  // namespace infra
