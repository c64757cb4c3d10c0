// rtrace from the outside: what goes in and what comes out. Expected figures follow from the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "command.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

/// A glowing unit sphere at the origin.
constexpr const char* ball =
    "void light shine 0 0 3 2 3 4\n"
    "shine sphere ball 0 0 4 0 0 0 1\n";

/// A rough floor under a lamp, for values that hang on random numbers.
constexpr const char* noisy =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 0 0 5 .5\n"
    "void plastic paint 0 0 5 .5 .4 .3 .2 .2\n"
    "paint ring floor 0 0 8 0 0 0 0 0 1 0 50\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n";

struct Rtrace : testing::Test {
    Folder folder;

    void scene(const std::string& text) {
        folder.write("scene.rad", text);
        const Outcome made = test::run(folder, "oconv scene.rad > scene.oct");
        ASSERT_EQ(made.status, 0) << made.err;
    }
    Outcome rtrace(const std::string& options, const std::string& rays) {
        folder.write("rays", rays);
        return test::run(folder, "rtrace " + options + " scene.oct < rays");
    }
};

TEST_F(Rtrace, prints_values_as_radiance_does) {
    scene(ball);
    const Outcome result = rtrace("-h -ovLpNsmM", "0 0 5 0 0 -2\n");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out,
              "2.000000e+00\t3.000000e+00\t4.000000e+00\t4.000000e+00\t"
              "0.000000e+00\t0.000000e+00\t1.000000e+00\t0.000000e+00\t0.000000e+00\t1.000000e+00\t"
              "ball\tshine\tshine\t\n");
    EXPECT_EQ(result.err, "");
}

// Two rays to the floor: each has a shadow ray, one to the lobe, and four over the hemisphere, which meet the
// sky or the lamp.
TEST_F(Rtrace, counts_rays_by_kind) {
    scene(noisy);
    const Outcome result = rtrace("-h -w- -stats -ab 1 -aa 0 -ad 4 -as 0 -st 0 -ss 1 -lw 1e-6",
                                  "0 0 3 .6 0 -.8\n1 0 3 .6 0 -.8\n");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "rtrace: 14 rays: 2 primary, 2 shadow, 8 ambient, 2 rough specular\n");
    const Outcome cached = rtrace("-h -w- -stats -ab 1 -aa .1 -ad 64 -as 0", "0 0 3 .6 0 -.8\n");
    EXPECT_NE(cached.err.find("; 1 values in the irradiance cache\n"), std::string::npos) << cached.err;
}

TEST_F(Rtrace, prints_a_miss_as_radiance_does) {
    scene(ball);
    const Outcome result = rtrace("-h -oLpNsv", "1 2 3 0 0 1\n");
    EXPECT_EQ(result.out,
              "1.000000e+10\t1.000000e+00\t2.000000e+00\t3.000000e+00\t"
              "0.000000e+00\t0.000000e+00\t0.000000e+00\t*\t0.000000e+00\t0.000000e+00\t0.000000e+00\t\n");
}

TEST_F(Rtrace, answers_a_zero_direction_with_an_empty_record) {
    scene(ball);
    EXPECT_EQ(rtrace("-h -oLs", "0 0 5 0 0 -1 0 0 5 0 0 0 0 0 3 0 0 -1").out,
              "4.000000e+00\tball\t\n1.000000e+10\t*\t\n2.000000e+00\tball\t\n");
}

TEST_F(Rtrace, writes_a_header_without_a_date) {
    scene(ball);
    const Outcome result = rtrace("-ovL -fad", "");
    EXPECT_TRUE(result.out.starts_with("#?RADIANCE\n")) << result.out;
    EXPECT_NE(result.out.find("\nrtrace -ovL -fad\nSOFTWARE= Infradiance "), result.out.npos) << result.out;
    EXPECT_TRUE(result.out.ends_with("\nNCOMP=4\nBigEndian=0\nFORMAT=double\n\n")) << result.out;
    EXPECT_EQ(result.out.find("CAPDATE"), result.out.npos);
}

TEST_F(Rtrace, reads_and_writes_raw_numbers) {
    scene(ball);
    const float ray[6] = {0, 0, 5, 0, 0, -1};
    const std::string bytes(reinterpret_cast<const char*>(ray), sizeof ray);
    const Outcome floats = rtrace("-h -ff -ov", bytes);
    const float expected[3] = {2, 3, 4};
    ASSERT_EQ(floats.out.size(), sizeof expected);
    EXPECT_EQ(std::memcmp(floats.out.data(), expected, sizeof expected), 0);
    EXPECT_EQ(rtrace("-h -ffa -oL", bytes).out, "4.000000e+00\t\n");
    // 4 = 128/256 * 2^3 sets the exponent; mantissas 2/8, 3/8, 4/8 of 256.
    EXPECT_EQ(rtrace("-h -ffc -ov", bytes).out, std::string("\x40\x60\x80\x83"));
}

TEST_F(Rtrace, writes_a_picture_size_and_stops_after_it) {
    scene(ball);
    const std::string rays = "0 0 5 0 0 -1 0 0 6 0 0 -1 0 0 7 0 0 -1";
    EXPECT_EQ(rtrace("-h -oL -x 2 -y 1", rays).out,
              "-Y        1 +X        2\n4.000000e+00\t\n5.000000e+00\t\n");
    EXPECT_EQ(rtrace("-h -oL -y 1", rays).out, "4.000000e+00\t\n");
    const Outcome short_of_rays = rtrace("-h -oL -x 2 -y 2", rays);
    EXPECT_EQ(short_of_rays.status, 0);
    EXPECT_EQ(short_of_rays.err, "rtrace: warning - unexpected EOF on input\n");
}

TEST_F(Rtrace, answers_each_ray_at_once_with_x_1) {
    scene(ball);
    // The second ray is written only after the first answer has been read.
    const Outcome result =
        test::run(folder,
                  "mkfifo in out; rtrace -h -oL -x 1 scene.oct < in > out & exec 3> in 4< out\n"
                  "echo 0 0 5 0 0 -1 >&3; read -r a <&4; echo 0 0 6 0 0 -1 >&3; read -r b <&4\n"
                  "exec 3>&-; wait; echo $a $b");
    EXPECT_EQ(result.out, "4.000000e+00 5.000000e+00\n") << result.err;
}

TEST_F(Rtrace, says_where_its_input_stops_making_sense) {
    scene(ball);
    const Outcome result = rtrace("-h -oL", "0 0 5 0 0 -1\n0 0 x 0 0 1\n");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "4.000000e+00\t\n");
    EXPECT_EQ(result.err, "rtrace: warning - input stops at ray 2: 'x' is no number\n");
    EXPECT_EQ(rtrace("-h -w- -oL", "0 0 5 0 0").err, "");
}

TEST_F(Rtrace, reaches_as_far_as_ld_allows) {
    scene(ball);
    EXPECT_EQ(rtrace("-h -ld+ -oLs", "0 0 5 0 0 -3.9 0 0 5 0 0 -4.1").out,
              "1.000000e+10\t*\t\n4.000000e+00\tball\t\n");
}

TEST_F(Rtrace, indents_the_tree_of_a_mirror_ray) {
    scene(
        "void metal chrome 0 0 5 .5 .5 .5 1 0\n"
        "chrome ring mirror 0 0 8 0 0 0 0 0 1 0 9\n"
        "void glow shine 0 0 4 2 2 2 0\n"
        "shine ring lid 0 0 8 0 0 5 0 0 -1 0 9\n");
    // Down to the mirror from z = 1, up to the lid: the reflected ray counts half.
    EXPECT_EQ(rtrace("-h -otsLvW", "0 0 1 0 0 -1").out,
              "\tlid\t5.000000e+00\t2.000000e+00\t2.000000e+00\t2.000000e+00\t"
              "5.000000e-01\t5.000000e-01\t5.000000e-01\t\n"
              "mirror\t1.000000e+00\t1.000000e+00\t1.000000e+00\t1.000000e+00\t"
              "1.000000e+00\t1.000000e+00\t1.000000e+00\t\n");
    EXPECT_EQ(rtrace("-h -ti shine -ots", "0 0 1 0 0 -1").out, "\tlid\t\n");
    EXPECT_EQ(rtrace("-h -te shine -ots", "0 0 1 0 0 -1").out, "mirror\t\n");
    EXPECT_EQ(rtrace("-h -oLtV", "0 0 1 0 0 -1").out,
              "\t1.000000e+00\t1.000000e+00\t1.000000e+00\t\n"
              "1.000000e+00\t1.000000e+00\t1.000000e+00\t\n"
              "1.000000e+00\t\n");
}

TEST_F(Rtrace, gives_the_same_with_any_number_of_threads) {
    scene(noisy);
    std::string rays;
    for (int i = 0; i < 500; ++i) rays += std::to_string(i * .01) + " 0 3 .1 .2 -1\n";
    const std::string options = "-h -w- -ab 1 -aa 0 -ad 16 -as 0 -ov ";
    const Outcome one = rtrace(options + "-n 1", rays);
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 500);
    EXPECT_EQ(rtrace(options + "-n 1", rays).out, one.out);
    EXPECT_EQ(rtrace(options + "-n 2", rays).out, one.out);
    EXPECT_EQ(rtrace(options + "-n 3 -x 7", rays).out, one.out);
}

TEST_F(Rtrace, ends_with_one_line_when_something_is_wrong) {
    scene(ball);
    const auto complaint = [&](const std::string& arguments) {
        const Outcome result = test::run(folder, "rtrace " + arguments + " < /dev/null");
        EXPECT_NE(result.status, 0) << arguments;
        EXPECT_LT(result.status, 4) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << arguments << result.err;
        EXPECT_EQ(result.out, "") << arguments;
        return result.err;
    };
    EXPECT_TRUE(complaint("").starts_with("rtrace: missing octree argument")) << complaint("");
    EXPECT_TRUE(complaint("-oq scene.oct").starts_with("rtrace: unrecognized output option 'q'"));
    EXPECT_TRUE(
        complaint("-zz scene.oct").starts_with("rtrace: command line error at '-zz': unknown option"));
    EXPECT_TRUE(complaint("scene.oct -h").starts_with("rtrace: command line error at 'scene.oct'"));
    EXPECT_NE(complaint("none.oct").find("none.oct"), std::string::npos);
    EXPECT_NE(complaint("-f none.cal scene.oct").find("none.cal"), std::string::npos);
    EXPECT_NE(complaint("-e a= scene.oct").find("1:3"), std::string::npos);
    EXPECT_NE(complaint("scene.rad").find("scene.rad"), std::string::npos);
}

TEST_F(Rtrace, keeps_messages_in_the_error_file) {
    scene(ball);
    const Outcome result = rtrace("-h -e messages -oL -y 2", "0 0 5 0 0 -1");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(
        folder.read("messages"),
        "**************\n*** rtrace -h -e messages -oL -y 2\nrtrace: warning - unexpected EOF on input\n");
}

}  // namespace
}  // namespace infra
