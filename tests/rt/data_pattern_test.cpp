// Patterns, textures and mixtures that look their values up in data files and pictures.
#include <gtest/gtest.h>

#include "common/planck/planck.h"
#include "scene_pieces.h"
#include "test_data.h"

namespace infra {
namespace {

class DataPattern : public ::testing::Test {
  protected:
    // Radiance of a plate with this modifier "m" above a place, in a surrounding of radiance 1.
    static Spectrum above(const std::string& modifier, double x, double y) {
        test::TracedScene scene(modifier + test::plate + test::surrounding(1), test::bounce_settings(1));
        return scene.radiance({x, y, 3}, {0, 0, -1});
    }
    static void expect_color(const Spectrum& seen, double red, double green, double blue) {
        EXPECT_NEAR(seen[0], red, 1e-6);
        EXPECT_NEAR(seen[1], green, 1e-6);
        EXPECT_NEAR(seen[2], blue, 1e-6);
    }

    const test::TemporaryFolder folder_;
    const test::DataFiles data_ = test::write_data(folder_);
    const std::string shine_ = " glow m 0 0 4 1 1 1 0";
};

constexpr double x = 0.3, y = 0.4, map = 0.1 + 0.4 * x + 0.25 * y;

TEST_F(DataPattern, BrightdataMultipliesByTheFunctionOfTheValue) {
    expect_color(above("void brightdata d 5 noop " + data_.map + " . Px Py 0 0 d" + shine_, x, y), map, map,
                 map);
    test::write_file(folder_ / "twice.cal", "twice(v) = 2*v*A1; across = Px; up = Py;");
    expect_color(above("void brightdata d 5 twice " + data_.map + " " + (folder_ / "twice.cal") +
                           " across up 0 1 5 d" + shine_,
                       x, y),
                 10 * map, 10 * map, 10 * map);
}

TEST_F(DataPattern, CoordinatesAreThoseOfTheTransform) {
    const std::string moved = "void brightdata d 9 noop " + data_.map + " . Px Py -t -.1 .2 0 0 0 d" + shine_;
    const double there = 0.1 + 0.4 * (x + 0.1) + 0.25 * (y - 0.2);
    expect_color(above(moved, x, y), there, there, there);
}

TEST_F(DataPattern, KelvinsOnAThermalOfOneKelvinAreATemperatureMap) {
    test::write_file(folder_ / "kelvin.dat", "1  0 1 2  280 320\n");
    const std::string hull = "void brightdata kelvin 4 noop " + (folder_ / "kelvin.dat") +
                             " . Px 0 0 kelvin thermal m 0 0 3 1 8 12";
    for (const double place : {0.0, 0.25, 0.9}) {
        const double radiance = band_radiance(280 + 40 * place, 8, 12);
        test::TracedScene scene(hull + test::plate);
        EXPECT_NEAR(scene.radiance({place, 0, 3}, {0, 0, -1})[0], radiance, 1e-5 * radiance);
    }
}

TEST_F(DataPattern, FunctionsOfColordataTakeAllValuesOrTheirOwn) {
    test::write_file(folder_ / "two.dat", "2  0 1 2  0 1 2   2 2 2 2\n");
    test::write_file(folder_ / "f.cal", "sum(a,b,c) = a + 10*b + 100*c; half(v) = v/2; first(v) = v;");
    const std::string files =
        data_.map + " " + (folder_ / "two.dat") + " " + data_.map + " " + (folder_ / "f.cal");
    expect_color(above("void colordata d 9 sum half sum " + files + " Px Py 0 0 d" + shine_, x, y),
                 20 + 101 * map, 1, 20 + 101 * map);
    // the first function is always given all three and takes what it needs
    expect_color(above("void colordata d 9 first first half " + files + " Px Py 0 0 d" + shine_, x, y), map,
                 2, map / 2);
}

TEST_F(DataPattern, ColorpictShowsThePictureOnce) {
    const std::string pattern =
        "void colorpict d 7 red green blue " + data_.picture + " . Px Py 0 0 d" + shine_;
    expect_color(above(pattern, x, y), x / 4, y / 2, 0.25);
    expect_color(above("void colorpict d 7 blue red noop " + data_.picture + " . Px Py 0 0 d" + shine_, x, y),
                 0.25, x / 4, 0.25);
}

TEST_F(DataPattern, TexdataBendsTheNormalByTheVectorInItsCoordinates) {
    test::write_file(folder_ / "f.cal", "along(a,b,c) = .5*a; none(a,b,c) = 0;");
    const std::string three = data_.map + " " + data_.map + " " + data_.map + " ";
    test::TracedScene scene("void texdata bend 13 along none none " + three + (folder_ / "f.cal") +
                            " Px Py -rz 90 -s 3 0 0 bend plastic m 0 0 5 1 1 1 0 0" + test::plate +
                            test::surrounding(1));
    // along local x, which is y here: the value does not depend on the scale
    const test::RaySpec view{{x, y, 3}, {0, 0, -1}};
    scene.tracer().start_stream(1);
    const Ray ray = scene.tracer().primary(view.origin, view.direction, 0);
    Interaction at(ray);
    scene.tracer().trace(at);
    const double value = 0.1 + 0.4 * (y / 3) + 0.25 * (-x / 3);
    EXPECT_NEAR(at.perturbation.x, 0, 1e-7);
    EXPECT_NEAR(at.perturbation.y, 0.5 * value, 1e-7);
}

TEST_F(DataPattern, MixturesTakeTheirShareFromData) {
    const std::string two = "void glow a 0 0 4 1 1 1 0 void glow b 0 0 4 3 3 3 0 void ";
    const double mixed = map + 3 * (1 - map);
    expect_color(above(two + "mixdata m 7 a b noop " + data_.map + " . Px Py 0 0", x, y), mixed, mixed,
                 mixed);
    test::write_file(folder_ / "f.cal", "over(v) = 9*v; under(v) = -v; own(r,g,b) = g;");
    const std::string cal = " " + (folder_ / "f.cal") + " ";
    expect_color(above(two + "mixdata m 7 a b over " + data_.map + cal + "Px Py 0 0", x, y), 1, 1, 1);
    expect_color(above(two + "mixdata m 7 a b under " + data_.map + cal + "Px Py 0 0", x, y), 3, 3, 3);
    const double green = y / 2 + 3 * (1 - y / 2);
    expect_color(above(two + "mixpict m 7 a b own " + data_.picture + cal + "Px Py 0 0", x, y), green, green,
                 green);
}

TEST_F(DataPattern, IsLeftOutWhereAFunctionHasNoValue) {
    for (const char* rest : {"sqrt(-1-Px*Px) Py", "Px 1/(Py-Py)"})
        expect_color(above("void brightdata d 5 noop " + data_.map + " . " + rest + " 0 0 d" + shine_, x, y),
                     1, 1, 1);
    test::write_file(folder_ / "f.cal", "root(v) = sqrt(-v);");
    expect_color(
        above("void brightdata d 5 root " + data_.map + " " + (folder_ / "f.cal") + " Px Py 0 0 d" + shine_,
              x, y),
        1, 1, 1);
}

}  // namespace
}  // namespace infra
