// rpict from the outside: pictures and what becomes of them. Expected figures follow from the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::error_of;
using test::Folder;
using test::Outcome;

/// A wall at y = 4 that fills the lower half of the default view, under a sky.
constexpr const char* wall =
    "void light paint 0 0 3 2 3 4\n"
    "paint polygon wall 0 0 12 -9 4 -9  9 4 -9  9 4 0  -9 4 0\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n";

/// Everything that draws random numbers: soft shadows, rough gloss, diffuse bounces.
constexpr const char* room =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 1 6 4 .5\n"
    "void plastic paint 0 0 5 .5 .4 .3 .2 .2\n"
    "paint polygon floor 0 0 12 -9 0 -1  9 0 -1  9 18 -1  -9 18 -1\n"
    "paint sphere ball 0 0 4 0 6 0 1\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n";

struct Rpict : testing::Test {
    Folder folder;

    void scene(const std::string& text) {
        folder.write("scene.rad", text);
        const Outcome made = test::run(folder, "oconv scene.rad > scene.oct");
        ASSERT_EQ(made.status, 0) << made.err;
    }
    Outcome rpict(const std::string& options) { return test::run(folder, "rpict " + options + " scene.oct"); }
    /// Renders into a file and reads it.
    Picture picture(const std::string& options, const std::string& name = "p.exr") {
        const Outcome result = rpict(options + " -o " + name);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_FALSE(folder.has(name + ".part"));
        return read_picture(folder.path(name));
    }
    bool left_nothing(const std::string& name) { return !folder.has(name) && !folder.has(name + ".part"); }
};

TEST_F(Rpict, sees_what_is_there) {
    scene(wall);
    const Picture image = picture("-x 8 -y 8 -ps 1 -pj 0");
    ASSERT_EQ(image.width, 8);
    ASSERT_EQ(image.height, 8);
    for (int column = 0; column < 8; ++column)
        for (int row = 0; row < 8; ++row)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(image.at(column, row)[c], row < 4 ? 1.0f : 2.0f + static_cast<float>(c))
                    << column << row;
}

TEST_F(Rpict, writes_radiances_header_without_a_date) {
    scene(wall);
    const Outcome result = rpict("-vh 90 -x 4 -y 4 -pa 0");
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string header = result.out.substr(0, result.out.find("\n\n"));
    EXPECT_TRUE(header.starts_with("#?RADIANCE\n")) << header;
    EXPECT_NE(header.find("\noconv scene.rad\n"), header.npos) << header;
    EXPECT_NE(header.find("\nrpict -vh 90 -x 4 -y 4 -pa 0\nSOFTWARE= Infradiance "), header.npos) << header;
    EXPECT_NE(
        header.find("\nVIEW= -vtv -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 90 -vv 45 -vo 0 -va 0 -vs 0 -vl 0\n"),
        header.npos)
        << header;
    EXPECT_NE(header.find("\nPIXASPECT=0.414214\n"), header.npos) << header;
    EXPECT_TRUE(header.ends_with("\nFORMAT=32-bit_rle_rgbe")) << header;
    EXPECT_EQ(result.out.substr(header.size() + 2, 24), "-Y        4 +X        4\n");
    EXPECT_EQ(rpict("-vh 90 -x 4 -y 4 -pa 0").out, result.out);
}

TEST_F(Rpict, describes_itself_in_openexr) {
    scene(wall);
    picture("-x 4 -y 4");
    const std::string bytes = folder.read("p.exr");
    for (const char* text : {"radiance", "W.m-2.sr-1", "rpict -x 4 -y 4 -o p.exr", "-vtv -vp 0 0 0"})
        EXPECT_NE(bytes.find(text), bytes.npos) << text;
    picture("-i -x 4 -y 4", "i.exr");
    EXPECT_NE(folder.read("i.exr").find("irradiance"), std::string::npos);
}

TEST_F(Rpict, writes_the_same_picture_in_both_formats) {
    scene(room);
    const std::string options = "-x 40 -y 40 -ps 1 -ab 1 -aa 0 -ad 16 -as 0";
    const Picture exact = picture(options, "p.exr");
    const Picture coded = picture(options, "p.hdr");
    ASSERT_EQ(exact.pixels.size(), coded.pixels.size());
    for (std::size_t i = 0; i < exact.pixels.size(); i += 3) {
        const float largest = std::max({exact.pixels[i], exact.pixels[i + 1], exact.pixels[i + 2]});
        for (std::size_t c = i; c < i + 3; ++c) EXPECT_NEAR(exact.pixels[c], coded.pixels[c], largest / 250);
    }
    const Outcome piped = rpict(options);
    const std::string file = folder.read("p.hdr");
    EXPECT_EQ(piped.out.substr(piped.out.find("\n\n")), file.substr(file.find("\n\n")));
}

TEST_F(Rpict, gives_the_same_bits_for_any_number_of_threads) {
    scene(room);
    for (const std::string sampling : {"-ps 1", "-ps 4 -pt .1", "-ps 3 -z d.zbf"}) {
        const std::string options = "-x 60 -y 50 -ab 1 -aa 0 -ad 16 -as 8 -dj .7 " + sampling;
        const Picture one = picture(options + " -n 1");
        const std::string depth = folder.has("d.zbf") ? folder.read("d.zbf") : "";
        for (const char* threads : {" -n 1", " -n 2", " -n 5", ""}) {
            const Picture other = picture(options + threads);
            ASSERT_EQ(other.pixels.size(), one.pixels.size());
            EXPECT_EQ(std::memcmp(other.pixels.data(), one.pixels.data(), one.pixels.size() * sizeof(float)),
                      0)
                << options << threads;
            EXPECT_EQ(folder.has("d.zbf") ? folder.read("d.zbf") : "", depth);
        }
    }
}

TEST_F(Rpict, interpolates_within_the_threshold) {
    scene(room);
    const std::string options = "-x 64 -y 64 -pj 0 -dj 0 -av .2 .2 .2 -st 1 ";
    const Picture full = picture(options + "-ps 1");
    const Picture sparse = picture(options + "-ps 4 -pt .05");
    double sum = 0, error = 0;
    int far_off = 0;
    for (std::size_t i = 0; i < full.pixels.size(); ++i) {
        const double difference = std::abs(double(full.pixels[i]) - double(sparse.pixels[i]));
        sum += double(full.pixels[i]);
        error += difference;
        if (difference > .05 * double(full.pixels[i])) ++far_off;
    }
    EXPECT_LT(error / sum, .01);
    EXPECT_LT(far_off, static_cast<int>(full.pixels.size()) / 50);
    EXPECT_GT(error, 0) << "nothing was interpolated";
}

TEST_F(Rpict, writes_distances) {
    scene(wall);
    EXPECT_EQ(rpict("-vtl -vh 4 -vv 4 -x 4 -y 4 -ps 1 -pj 0 -z d.zbf -o p.hdr").status, 0);
    const std::string bytes = folder.read("d.zbf");
    float depth[16];
    ASSERT_EQ(bytes.size(), sizeof depth);
    std::memcpy(depth, bytes.data(), sizeof depth);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(depth[i], i < 8 ? 1e10f : 4.0f) << i;
}

TEST_F(Rpict, leaves_the_outside_of_a_fisheye_black) {
    scene(wall);
    const Picture image = picture("-vth -vh 180 -vv 180 -x 16 -y 16 -ps 1 -pj 0");
    EXPECT_EQ(image.at(0, 0)[0], 0);
    EXPECT_EQ(image.at(15, 15)[1], 0);
    EXPECT_GT(image.at(8, 8)[0], 0);
}

TEST_F(Rpict, sees_nothing_outside_its_clipping_planes) {
    scene(wall);
    const std::string options = "-vtl -vh 4 -vv 4 -vl -.5 -x 2 -y 2 -ps 1 ";
    EXPECT_EQ(picture(options).at(0, 1)[0], 2);
    EXPECT_EQ(picture(options + "-va 3.9").at(0, 1)[0], 0);
    EXPECT_EQ(picture(options + "-vo 4.1").at(0, 1)[0], 1);
}

TEST_F(Rpict, takes_its_octree_from_a_command_and_from_its_input) {
    scene(wall);
    const std::string options = "rpict -x 4 -y 4 ";
    const std::string file = test::run(folder, options + "scene.oct").out;
    EXPECT_EQ(test::run(folder, options + "'!oconv scene.rad'").out, file);
    EXPECT_EQ(test::run(folder, options + "< scene.oct").out, file);
}

TEST_F(Rpict, leaves_nothing_that_looks_whole_when_it_is_stopped) {
    scene(room);
    // The first report tells that rays are being traced. A background command of a shell ignores SIGINT; env
    // undoes it.
    const auto stop = [&](const std::string& signal, const std::string& output) {
        return test::run(folder,
                         "rm -f log; env --default-signal=INT rpict -t 1000 -ab 5 -ad 4096 -ps 1 -x 2000 -y "
                         "2000 -z z.zbf " +
                             output +
                             " 2> log & while ! grep -q rays log && kill -0 $!; do sleep .02; done; kill -" +
                             signal + " $!; wait $!");
    };
    for (const char* signal : {"TERM", "INT"}) {
        EXPECT_EQ(stop(signal, "-o p.hdr scene.oct").status, 3);
        EXPECT_TRUE(folder.read("log").ends_with(
            "rpict: interrupted (the same command with -ro \"p.hdr\" goes on from \"p.hdr.partial\")\n"))
            << folder.read("log");
        EXPECT_TRUE(left_nothing("p.hdr"));
        EXPECT_TRUE(left_nothing("z.zbf"));
        EXPECT_TRUE(folder.has("p.hdr.partial"));
        EXPECT_FALSE(folder.has("p.hdr.partial.part"));
    }
    EXPECT_EQ(stop("TERM", "scene.oct > p.hdr").status, 3);
    EXPECT_NE(error_of([&] { read_picture(folder.path("p.hdr")); }).find("unknown picture format"),
              std::string::npos);
    EXPECT_EQ(stop("TERM", "-o /dev/null scene.oct").status, 3);  // which cannot be gone on with
    EXPECT_TRUE(folder.read("log").ends_with("rpict: interrupted\n")) << folder.read("log");
}

TEST_F(Rpict, reports_progress) {
    scene(wall);
    const Outcome result = rpict("-t 1 -x 4 -y 4 -o p.hdr");
    EXPECT_TRUE(result.err.starts_with("rpict: 0 rays, 0.00% after ")) << result.err;
    EXPECT_NE(result.err.find(" rays, 100.00% after "), result.err.npos) << result.err;
}

TEST_F(Rpict, ends_with_one_line_when_something_is_wrong) {
    scene(wall);
    const auto complaint = [&](const std::string& arguments) {
        const Outcome result = test::run(folder, "rpict -o p.hdr " + arguments);
        EXPECT_NE(result.status, 0) << arguments;
        EXPECT_LT(result.status, 4) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << arguments << result.err;
        EXPECT_TRUE(left_nothing("p.hdr")) << arguments;
        return result.err;
    };
    EXPECT_NE(complaint("-vd 0 0 1 scene.oct").find("view up parallel to view direction"), std::string::npos);
    EXPECT_NE(complaint("-vf none.vf scene.oct").find("none.vf"), std::string::npos);
    EXPECT_NE(complaint("none.oct").find("none.oct"), std::string::npos);
    EXPECT_NE(complaint("scene.rad").find("scene.rad"), std::string::npos);
    EXPECT_NE(complaint("a.oct b.oct").find("'a.oct'"), std::string::npos);
    EXPECT_NE(complaint("-o no_such_folder/p.hdr scene.oct").find("no_such_folder/p.hdr"), std::string::npos);
    EXPECT_NE(complaint("-x 2000000000 -y 2000000000 scene.oct").find("too large"), std::string::npos);
    EXPECT_NE(complaint("-ap map scene.oct").find("cannot open photon map \"map\""), std::string::npos);
    folder.write("old.gpm", "#?RADIANCE\n\n");
    EXPECT_NE(complaint("-ap old.gpm scene.oct").find("old.gpm: this is no photon map"), std::string::npos);
    const auto made = std::filesystem::last_write_time(folder.path("scene.oct"));
    std::filesystem::last_write_time(folder.path("old.gpm"), made - std::chrono::hours(1));
    EXPECT_NE(complaint("-ap old.gpm scene.oct").find("old.gpm: this photon map is older than the octree"),
              std::string::npos);
}

}  // namespace
}  // namespace infra
