// -pm and -pd against closed forms: moments of the picture of a bright disk.
//
// A disk of radius r at distance D in front of a perspective view covers a circle of radius r/D in the image
// plane at distance 1. Depth of field and motion spread it; variances add up.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using std::numbers::pi;
using test::Folder;
using test::Outcome;

constexpr int side = 600;  // pixels
constexpr double radius = 0.2, distance = 10;
const double pixels_per_tangent = side / (2 * std::tan(10 * pi / 180));
constexpr const char* size = " -x 600 -y 600 -vh 20 -vv 20 -ps 1 ";

/// Of the pixels, weighted by their value, in pixels from the middle of the picture.
struct Moments {
    double sum = 0, x = 0, y = 0, variance_x = 0, variance_y = 0;

    explicit Moments(const Picture& picture) {
        double xx = 0, yy = 0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double value = picture.at(column, row)[0];
                const double u = column + 0.5 - side / 2.0, v = side / 2.0 - row - 0.5;
                sum += value, x += u * value, y += v * value;
                xx += u * u * value, yy += v * v * value;
            }
        x /= sum, y /= sum;
        variance_x = xx / sum - x * x;
        variance_y = yy / sum - y * y;
    }
};

struct RpictBlur : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("disk.rad",
                     "void light lum 0 0 3 1 1 1\n"
                     "lum ring disk 0 0 8 0 10 0 0 -1 0 0 .2\n");
        ASSERT_EQ(test::run(folder, "oconv disk.rad > disk.oct").status, 0);
    }
    Picture picture(const std::string& options, const std::string& views = "") {
        folder.write("views", views);
        const Outcome result = test::run(folder, "rpict" + (size + options) + " disk.oct < views > p.hdr");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return read_picture(folder.path("p.hdr"));
    }
};

const double disk_pixels = radius / distance * pixels_per_tangent;
constexpr double jitter_variance = 1.0 / 12;  // -pj 1: a pixel's width

TEST_F(RpictBlur, out_of_focus_a_disk_is_as_wide_as_the_circle_of_confusion) {
    // Rays of one image point meet at distance F, and have spread over the lens's width times |D/F - 1| at D.
    for (const double focus : {4.0, 40.0}) {
        constexpr double aperture = 0.5;
        const double spread = aperture / 2 * std::abs(1 / focus - 1 / distance) * pixels_per_tangent;
        const double expected = (spread * spread + disk_pixels * disk_pixels) / 4 + jitter_variance;
        const Moments found(picture("-pj 1 -pd .5 -vd 0 " + std::to_string(focus) + " 0"));
        // Of n pixels within reach a share p is lit: the flux has the deviation sqrt(n p (1 - p)).
        const double lit = pi * disk_pixels * disk_pixels, reached = pi * std::pow(spread + disk_pixels, 2);
        const double deviation = std::sqrt(lit * (1 - lit / reached));
        EXPECT_NEAR(found.sum, lit, 4 * deviation) << focus;
        EXPECT_NEAR(found.variance_x / expected, 1, 4 / std::sqrt(lit)) << focus;
        EXPECT_NEAR(found.variance_y / expected, 1, 4 / std::sqrt(lit)) << focus;
        EXPECT_NEAR(found.x, 0, 4 * std::sqrt(expected / lit));
        EXPECT_NEAR(found.y, 0, 4 * std::sqrt(expected / lit));
    }
}

TEST_F(RpictBlur, in_focus_a_disk_is_sharp) {
    const Picture sharp = picture("-vd 0 10 0"), focused = picture("-vd 0 10 0 -pd .5");
    int different = 0;
    for (std::size_t i = 0; i < sharp.pixels.size(); ++i) different += sharp.pixels[i] != focused.pixels[i];
    EXPECT_LE(different, 6);  // a rounding may decide at the rim
}

TEST_F(RpictBlur, a_lens_at_a_fisheye_has_the_same_spread) {
    // An equidistant view: near its middle as a perspective one of 20 degrees, whose scale differs by 1 %.
    const double per_radian = side / (20 * pi / 180), disk = radius / distance * per_radian;
    const double spread = 0.25 * std::abs(1 / 4.0 - 1 / distance) * per_radian;
    const double expected = (spread * spread + disk * disk) / 4 + jitter_variance;
    const Moments found(picture("-vta -pj 1 -pd .5 -vd 0 4 0"));
    EXPECT_NEAR(found.variance_x / expected, 1, 4 / std::sqrt(pi * disk * disk) + 0.01);
    EXPECT_NEAR(found.variance_y / expected, 1, 4 / std::sqrt(pi * disk * disk) + 0.01);
}

TEST_F(RpictBlur, motion_spreads_along_its_way) {
    // From view to view the disk moves by half a unit; the shutter is open for 0.8 of that.
    const double way = 0.5 / distance * pixels_per_tangent;
    const Picture blurred = picture("-pj 1 -pm .8 -S 7 -vp -.25 0 0", "VIEW= -vp .25 0 0\n");
    const Moments found(blurred);
    const double across = disk_pixels * disk_pixels / 4 + jitter_variance;
    const double along = across + std::pow(0.8 * way, 2) / 12;
    const double lit = pi * disk_pixels * disk_pixels;
    EXPECT_NEAR(found.sum, lit, 4 * std::sqrt(lit));
    EXPECT_NEAR(found.x, -way / 2, 4 * std::sqrt(along / lit));  // where the view itself sees it
    EXPECT_NEAR(found.variance_x / along, 1, 4 / std::sqrt(lit));
    EXPECT_NEAR(found.variance_y / across, 1, 4 / std::sqrt(lit));
}

TEST_F(RpictBlur, the_picture_numbered_one_is_sharp) {
    const Picture first = picture("-pm .8 -S 1 -vp -.25 0 0", "VIEW= -vp .25 0 0\n");
    EXPECT_EQ(first.pixels, picture("-vp .25 0 0").pixels);
}

TEST_F(RpictBlur, is_the_same_for_any_number_of_threads) {
    const std::string options = "-pj 1 -pm .8 -pd .5 -vd 0 4 0 -S 2 -vp -.25 0 0 -n ";
    EXPECT_EQ(picture(options + "1", "VIEW= -vp .25 0 0\n").pixels,
              picture(options + "3", "VIEW= -vp .25 0 0\n").pixels);
}

}  // namespace
}  // namespace infra
