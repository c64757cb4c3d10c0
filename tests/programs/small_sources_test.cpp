// Lamps smaller than the distance between samples: their flux in the picture is their area times radiance.
#include "rt/programs/small_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using std::numbers::pi;
using test::Folder;
using test::Outcome;

TEST(ImagePolygon, is_measured_and_cut) {
    const ImagePolygon box{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
    EXPECT_DOUBLE_EQ(polygon_area(box), 8);
    EXPECT_DOUBLE_EQ(polygon_width(box), 2);
    EXPECT_DOUBLE_EQ(polygon_area(clipped(box, 1, 1, 2, 5)), 1);
    EXPECT_DOUBLE_EQ(polygon_area(clipped(box, -1, -1, 9, 9)), 8);
    EXPECT_TRUE(clipped(box, 5, 0, 6, 1).empty());
    const ImagePolygon triangle{{0, 0}, {3, 0}, {0, 4}};
    EXPECT_DOUBLE_EQ(polygon_width(triangle), 12.0 / 5);
    // The pixels of a grid share a polygon out among them.
    double sum = 0;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 4; ++y) sum += polygon_area(clipped(triangle, x, y, x + 1, y + 1));
    EXPECT_NEAR(sum, 6, 1e-12);
}

struct SmallSources : testing::Test {
    static constexpr int side = 100;
    Folder folder;
    const double scale = side / (2 * std::tan(10 * pi / 180));  // pixels per tangent

    Picture picture(const std::string& scene, const std::string& options = "") {
        folder.write("s.rad", "void light lum 0 0 3 50 60 70\n" + scene);
        const Outcome result = test::run(folder, "oconv s.rad > s.oct && rpict -x 100 -y 100 -vh 20 -vv 20 " +
                                                     options + " -o p.exr s.oct");
        EXPECT_EQ(result.status, 0) << result.err;
        return read_picture(folder.path("p.exr"));
    }
    /// Of the green channel over a background.
    static double flux(const Picture& picture, double background = 0) {
        double sum = 0;
        for (std::size_t i = 1; i < picture.pixels.size(); i += 3) sum += picture.pixels[i] - background;
        return sum;
    }
    /// A number of the scene for a length in pixels at distance 10.
    std::string length(double pixels) const { return std::to_string(pixels / scale * 10) + "0 "; }
};

constexpr const char* wall =
    "void glow g 0 0 4 2 2 2 0\ng polygon w 0 0 12 -9 20 -9  9 20 -9  9 20 9  -9 20 9\n";

TEST_F(SmallSources, of_any_size_have_their_flux) {
    // Pixels are plane, so a sphere's share of the picture is its solid angle times scale^2 near the middle.
    for (const char* const sampling : {"-ps 1 -pj 0", "-ps 1", "-ps 4", "-ps 8 -pt .5"})
        for (const double diameter : {0.05, 0.3, 0.9, 3.0}) {
            const double radius = std::stod(length(diameter / 2)), distance = std::hypot(10, .031, .017);
            const double sine = radius / distance;
            const double area = 2 * pi * (1 - std::sqrt(1 - sine * sine)) * scale * scale;
            const std::string sphere = "lum sphere s 0 0 4 .031 10 .017 " + length(diameter / 2) + "\n";
            if (diameter > std::atoi(sampling + 4)) continue;
            EXPECT_NEAR(flux(picture(sphere, sampling)) / (60 * area), 1, 0.003) << sampling << diameter;
            EXPECT_NEAR(flux(picture(sphere + wall, sampling), 2) / (58 * area), 1, 0.003)
                << sampling << diameter;
        }
}

TEST_F(SmallSources, of_any_shape_have_their_flux) {
    const std::string r = length(0.4), size = "-ps 4";
    const double circle = pi * 0.4 * 0.4;
    EXPECT_NEAR(flux(picture("lum ring r 0 0 8 .1 10 .2 0 -1 0 0 " + r + "\n", size)), 60 * circle,
                0.005 * 60 * circle);
    const std::string x = length(1.5), z = length(0.7);
    EXPECT_NEAR(flux(picture(
                    "lum polygon p 0 0 12 0 10 0 " + x + "10 0 " + x + "10 " + z + "0 10 " + z + "\n", size)),
                60 * 1.5 * 0.7, 0.005 * 60 * 1.5 * 0.7);
    const std::string d = length(.6);
    EXPECT_NEAR(flux(picture("lum polygon p 0 0 9 0 10 0 " + d + "10 0 0 10 " + d + "\n", size)), 60 * .18,
                0.005 * 60 * .18);
    EXPECT_NEAR(
        flux(picture(
            "lum cylinder c 0 0 7 .1 10 -" + length(10) + ".1 10 " + length(10) + length(0.15) + "\n", size)),
        60 * 20 * .3, 0.01 * 60 * 20 * .3);
    const double degrees = 2 * std::atan(0.3 / scale) * 180 / pi;
    EXPECT_NEAR(flux(picture("lum source s 0 0 4 .01 1 .02 " + std::to_string(degrees) + "\n", size)),
                60 * pi * .09, 0.01 * 60 * pi * .09);
    EXPECT_EQ(flux(picture("lum ring r 0 0 8 .1 10 .2 0 1 0 0 " + r + "\n", size)), 0);  // its back
}

TEST_F(SmallSources, are_hidden_by_what_is_before_them) {
    const std::string sphere = "lum sphere s 0 0 4 .031 10 .017 " + length(0.3);
    const std::string screen =
        "\nvoid plastic black 0 0 5 0 0 0 0 0\nblack polygon b 0 0 12 -1 5 -1  1 5 -1  1 5 1  -1 5 1\n";
    EXPECT_EQ(flux(picture(sphere + screen, "-ps 1")), 0);
    EXPECT_GT(flux(picture(sphere + screen, "-ps 1 -vo 6")), 10);
    EXPECT_EQ(flux(picture(sphere, "-dv- -ps 1")), 0);
}

TEST_F(SmallSources, do_not_colour_what_is_behind_them) {
    // Adaptive sampling must not spread the lamp: all but the pixels that it touches are the wall's.
    const Picture found = picture("lum sphere s 0 0 4 .01 10 .01 " + length(0.6) + "\n" + wall, "-ps 4");
    int touched = 0;
    for (std::size_t i = 0; i < found.pixels.size(); i += 3) touched += found.pixels[i] != 2;
    EXPECT_GE(touched, 1);
    EXPECT_LE(touched, 4);
}

TEST_F(SmallSources, give_their_distance_to_the_pixel) {
    picture("lum sphere s 0 0 4 .01 10 .01 " + length(0.15) + "\n" + wall, "-ps 4 -z z");
    const std::string bytes = folder.read("z");
    std::vector<float> depth(bytes.size() / sizeof(float));
    std::memcpy(depth.data(), bytes.data(), bytes.size());
    EXPECT_NEAR(*std::min_element(depth.begin(), depth.end()), 10, 0.05);
    EXPECT_EQ(std::count_if(depth.begin(), depth.end(), [](float d) { return d < 19; }), 1);
}

}  // namespace
}  // namespace infra
