// lib/rayinit.cal and the built-in functions of the ray tracer, against figures that RADIANCE 6.1 gives.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/vec.h"
#include "evaluate.h"

namespace infra::cal {
namespace {

struct Figure {
    const char* expression;
    double value;
};

/// A ray from (x + .25, .5, 2) along (.125, -.0625, -1) to the plane z = 0, on a surface seen from above.
struct RayWorld {
    explicit RayWorld(double x) {
        const Vec3 direction = normalize({.125, -.0625, -1});
        const double distance = -2 / direction.z;
        values.assign(38, 0.);
        set(ray_direction, direction);
        set(surface_normal, {0, 0, 1});
        set(intersection_point, Vec3{x + .25, .5, 2} + distance * direction);
        values[total_distance] = values[shadow_distance] = distance;
        values[ray_dot] = -direction.z;
    }
    void set(int channel, const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis) values[static_cast<std::size_t>(channel + axis)] = v[axis];
    }
    std::vector<double> values;
};

void expect_figures(std::span<const Figure> figures, double x, std::span<const double> reals) {
    Library library = make_ray_library();
    std::vector<ExprId> ids;
    for (const Figure& figure : figures) ids.push_back(library.compile(figure.expression, test_text));
    Evaluator evaluator(library.link());
    CountingHost world(RayWorld(x).values);
    world.host.reals = reals;
    for (std::size_t i = 0; i < figures.size(); ++i)
        EXPECT_NEAR(evaluator.evaluate(ids[i], world.host), figures[i].value,
                    1e-6 * std::abs(figures[i].value) + 1e-12)
            << figures[i].expression;
}

TEST(RayLibrary, FunctionsHaveTheirPublishedValues) {
    constexpr std::array<double, 3> reals{1, 2.5, -3};
    constexpr Figure figures[] = {
        {"hermite(1,4,2,-1,.3)", 2.005},
        {"hermite(1,2,3,4,.7)", 1.385},
        {"bezier(1,2,4,3,.3)", 2.062},
        {"bspline(1,2,4,3,.3)", 2.643667},
        {"erf(.5)", .5204999},
        {"erfc(.5)", .4795001},
        {"unif2norm(.2)", -.8414567},
        {"unif2norm(.9)", 1.281729},
        {"tri(5.3,2)", 1.3},
        {"mod(-3,5)", 2},
        {"frac(-1.25)", .75},
        {"sgn(-4)", -1},
        {"abs(-4)", 4},
        {"bound(1,7,3)", 3},
        {"clip(1.7)", 1},
        {"linterp(.25,4,8)", 5},
        {"and(1,-2)", -2},
        {"or(-1,2)", 2},
        {"not(3)", -1},
        {"xor(1,1)", -1},
        {"inside(1,2,3)", 1},
        {"fade(3,1,2)", 1.4},
        {"fade(3,1,20)", 1},
        {"grey(.2,.4,.6)", .35994744},
        {"clip_b(.2,.4,1.6)", 1},
        {"Acos(2)", 0},
        {"Asin(-3)", -1.5707963},
        {"Atan2(0,0)", 0},
        {"Exp(-200)", 0},
        {"Sqrt(-4)", 0},
        {"DEGREE", .017453293},
        {"FTINY", 1e-7},
        {"arg(0)", 3},
        {"A3", -3},
        {"AC", 3},
        {"arg(1.6)", 2.5},
        {"min(3,A1)", 1},
        {"dot(N,D)", -.99037524},
        {"cross(1,N,D)", .061898452},
    };
    expect_figures(figures, 0, reals);
}

TEST(RayLibrary, NoiseIsRadiancesNoise) {
    constexpr Figure figures[] = {
        {"noise3(1.2,3.4,5.6)", -.5299883},
        {"noise3(-1.7,2.3,-9.4)", -.1285777},
        {"noise3(2,3,4)", 0},
        {"noise3(-2,-3,.5)", .25},
        {"noise3a(1.2,3.4,5.6)", .3942998},
        {"noise3d(3,1.2,3.4,5.6)", -.5011320},
        {"noise3x(-1.7,2.3,-9.4)", .2538877},
        {"noise3y(-1.7,2.3,-9.4)", 1.339437},
        {"noise3z(-1.7,2.3,-9.4)", 1.856498},
        {"fnoise3(7.7,.2,3.3)", .04012033},
        {"fnoise3(-4.1,.6,9)", -.05015431},
        {"fnoise3(1,2,3)", -.6420448},
        {"fnoise3(-.3,-.2,1000)", -.06796091},
        {"fnoise3(.5,.5,.5)", -.3412551},
        {"turbulence(1.1,2.2,3.3,.1)", .3409675},
        {"turbulence(.3,.4,.5,.05)", .2660514},
        {"turbulencex(1.1,2.2,3.3,.2)", -1.021493},
        {"turbulencey(.3,.4,.5,.05)", -.2086607},
        {"turbulencez(.3,.4,.5,.05)", 1.513758},
        {"turbulencez(2.1,.2,.3,.2)", -.8039069},
        {"rand(1)", .35008306},
        {"rand(0)", .954473516},
        {"rand(-3.7)", .0311368565},
        {"nrand(7)", 1.808646},
        {"nrand(3)", -.4718698},
    };
    expect_figures(figures, 0, {});
}

TEST(RayLibrary, LuminairesAreCorrectedForTheirShape) {
    constexpr std::array<double, 4> reals{1.5, 2, 3, .5};
    constexpr Figure above[] = {{"source_corr(2,0)", 3},
                                {"source_corr(2,1)", 3.029155},
                                {"source_corr(2,2)", .4846648},
                                {"source_corr(2,4)", .7610717},
                                {"source_theta(0)", 172.0442},
                                {"source_phi(360)", 153.4350},
                                {"source_phi(180)", 153.4350},
                                {"source_phi(90)", 26.56505},
                                {"Ts", 2.019437},
                                {"Rdot", .9903752}};
    expect_figures(above, 0, reals);
    constexpr Figure beside[] = {{"source_corr(2,3)", .1335165}};
    expect_figures(beside, 24, reals);
    constexpr Figure level[] = {{"U", 36.5}, {"V", .375}};
    expect_figures(level, 36, reals);
}

}  // namespace
}  // namespace infra::cal
