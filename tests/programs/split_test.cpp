// rpict -split: what a pixel's radiance consists of, against closed forms.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

/// The values of every channel of a file, by name.
std::map<std::string, std::vector<float>> read_channels(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const auto& window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::map<std::string, std::vector<float>> values;
    Imf::FrameBuffer frame;
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c) {
        auto& own = values[c.name()];
        own.resize(std::size_t(width) * height);
        frame.insert(c.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(own.data()), sizeof(float),
                                          sizeof(float) * width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

struct SplitPicture : testing::Test {
    Folder folder;
    std::map<std::string, std::vector<float>> values;

    /// Renders and reads s.exr.
    void render(const std::string& scene, const std::string& options) {
        folder.write("scene.rad", scene);
        const Outcome result = test::run(
            folder, "oconv scene.rad > scene.oct && rpict -w -t 0 -x 2 -y 2 -ps 1 -lw 1e-6 -split s.exr " +
                        options + " scene.oct > p.hdr");
        ASSERT_EQ(result.status, 0) << result.err;
        values = read_channels(folder.path("s.exr"));
    }
    /// Mean over the picture.
    double mean(const std::string& channel) const {
        const std::vector<float>& own = values.at(channel);
        double sum = 0;
        for (const float value : own) sum += static_cast<double>(value);
        return sum / static_cast<double>(own.size());
    }
    void expect_sum(const std::string& color) const {
        double sum = 0;
        for (const auto& [name, own] : values)
            if (name.ends_with("." + color)) sum += mean(name);
        EXPECT_NEAR(sum, mean(color), 1e-6 * mean(color));
    }
};

/// A plate facing up, seen from above, between a sky of 10 and a sea of 40, under a sun of half a degree.
constexpr const char* plate =
    "void glow sky 0 0 4 10 10 10 0\nsky source above 0 0 4 0 0 1 180\n"
    "void glow sea 0 0 4 40 40 40 0\nsea source below 0 0 4 0 0 -1 180\n"
    "void light star 0 0 3 1000 2000 3000\nstar source sun 0 0 4 0 .6 .8 .5\n"
    "void plastic paint 0 0 5 .5 .5 .5 0 0\nvoid emissive skin 1 paint 0 3 7 8 9\n"
    "skin polygon plate 0 0 12 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n";
constexpr const char* from_above = "-vp 0 0 5 -vd 0 0 -1 -vu 0 1 0 -vh 5 -vv 5 ";

TEST_F(SplitPicture, of_a_plate_under_sky_and_sun) {
    render(plate, std::string(from_above) + "-ab 1 -ad 64 -as 0 -aa 0");
    EXPECT_NEAR(mean("emitted.G"), 8, 1e-6);
    EXPECT_NEAR(mean("reflected_sky.G"), .5 * 10, 1e-5);  // one value for all directions: no noise
    const double omega = 2 * std::numbers::pi * (1 - std::cos(.25 * std::numbers::pi / 180));
    EXPECT_NEAR(mean("reflected_sun.B"), .5 / std::numbers::pi * 3000 * omega * .8, 2e-5 * 3000 * omega);
    EXPECT_EQ(mean("reflected_sea.G"), 0);
    EXPECT_EQ(mean("reflected_ship.G"), 0);
    EXPECT_EQ(mean("path.G"), 0);
    EXPECT_EQ(mean("assumed.G"), 0);
    for (const char* color : {"R", "G", "B"}) expect_sum(color);
}

TEST_F(SplitPicture, is_the_same_with_cached_irradiance) {
    render(plate, std::string(from_above) + "-ab 1 -ad 256 -as 0 -aa .1");
    EXPECT_NEAR(mean("reflected_sky.G"), .5 * 10, 1e-4);
    EXPECT_NEAR(mean("emitted.G"), 8, 1e-6);
    EXPECT_EQ(mean("reflected_sea.G"), 0);
    expect_sum("G");
}

TEST_F(SplitPicture, sums_to_the_picture_that_is_not_split) {
    const std::string options = std::string(from_above) + "-ab 2 -ad 16 -as 0 -aa 0 -av .3 .2 .1";
    render(plate, options);
    const Outcome plain =
        test::run(folder, "rpict -w -x 2 -y 2 -ps 1 -lw 1e-6 -o q.exr " + options + " scene.oct");
    ASSERT_EQ(plain.status, 0) << plain.err;
    const std::map<std::string, std::vector<float>> whole = read_channels(folder.path("q.exr"));
    for (const char* color : {"R", "G", "B"})
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(values.at(color)[i], whole.at(color)[i], 1e-5F * whole.at(color)[i]);
    EXPECT_EQ(read_picture(folder.path("p.hdr")).channels, 3);
}

TEST_F(SplitPicture, assumes_what_av_says) {
    render(plate, std::string(from_above) + "-ab 0 -av 4 5 6");
    EXPECT_NEAR(mean("assumed.G"), .5 * 5, 1e-6);
    EXPECT_NEAR(mean("emitted.G"), 8, 1e-6);
}

// Radiance after b reflections in a closed sphere of emission e and reflectance r is e r^b.
TEST_F(SplitPicture, counts_the_bounces) {
    const std::string sphere =
        "void plastic grey 0 0 5 .5 .5 .5 0 0\nvoid emissive wall 1 grey 0 3 1 1 1\nwall bubble room 0 0 4 0 "
        "0 0 1\n";
    render(sphere, "-vp 0 0 0 -vd 0 1 0 -vh 20 -vv 20 -ab 4 -ad 4 -as 0 -aa 0 -lr 9 -splitb 3");
    EXPECT_NEAR(mean("emitted.R"), 1, 1e-6);
    EXPECT_NEAR(mean("reflected_ship1.R"), .5, 1e-5);
    EXPECT_NEAR(mean("reflected_ship2.R"), .25, 1e-5);
    EXPECT_NEAR(mean("reflected_ship3.R"), .125 + .0625, 1e-5);  // the third and the fourth
    EXPECT_EQ(mean("reflected_sky1.R"), 0);
    expect_sum("R");
}

TEST_F(SplitPicture, tells_the_air_apart) {
    folder.write("air.txt", "5 .25 3\n");  // at the plate's distance
    render(plate, std::string(from_above) + "-ab 1 -ad 64 -as 0 -aa 0 -mp air.txt -x 1 -y 1 -vh .01 -vv .01");
    EXPECT_NEAR(mean("path.G"), 3, 1e-3);
    EXPECT_NEAR(mean("emitted.G"), .25 * 8, 1e-3);
    EXPECT_NEAR(mean("reflected_sky.G"), .25 * 5, 1e-3);
    expect_sum("G");
}

// What arrives from the sea is the sea's, whatever its light was before; without -splitm it is a ship's.
TEST_F(SplitPicture, takes_surfaces_for_what_it_is_told) {
    const std::string scene = std::string(
        "void glow sky 0 0 4 10 10 10 0\nsky source above 0 0 4 0 0 1 180\n"
        "void mirror water 0 0 3 .5 .5 .5\nwater ring sea 0 0 8 0 0 0 0 0 1 0 1e4\n"
        "void plastic paint 0 0 5 .5 .5 .5 0 0\n"
        "paint polygon hull 0 0 12 -1 0 9 1 0 9 1 0 11 -1 0 11\n");
    const std::string view = "-vp 0 -5 10 -vd 0 1 0 -vh 5 -vv 5 -ab 1 -ad 1024 -as 0 -aa 0 ";
    render(scene, view + "-splitm sea water");
    // Half of the hemisphere each, stratified; the mirror keeps half.
    EXPECT_NEAR(mean("reflected_sky.G"), .5 * .5 * 10, .02);
    EXPECT_NEAR(mean("reflected_sea.G"), .5 * .5 * 5, .02);
    EXPECT_EQ(mean("reflected_ship.G"), 0);
    const double as_sea = mean("reflected_sea.G");
    render(scene, view);
    EXPECT_EQ(mean("reflected_ship.G"), as_sea);
    EXPECT_EQ(mean("reflected_sea.G"), 0);
}

TEST_F(SplitPicture, sees_through_what_is_not_there) {
    const std::string veil = std::string(plate) +
                             "void plastic film 0 0 5 1 1 1 0 0\nvoid mixfunc hole 4 void film "
                             "1 . 0 0\nhole polygon veil 0 0 12 -9 -9 1 9 -9 1 9 9 1 -9 9 1\n";
    render(veil, std::string(from_above) + "-ab 1 -ad 64 -as 0 -aa 0");
    EXPECT_NEAR(mean("emitted.G"), 8, 1e-6);
    EXPECT_NEAR(mean("reflected_sky.G"), .5 * 10, 1e-5);
    EXPECT_EQ(mean("reflected_ship.G"), 0);
}

TEST_F(SplitPicture, in_spectral_channels_has_all_of_them_in_every_component) {
    render(plate, std::string(from_above) + "-cs 4 -cw 8000 12000 -ab 1 -ad 16 -as 0 -aa 0");
    int layers = 0;
    for (const auto& [name, own] : values) layers += name.starts_with("reflected_sky.S0.");
    EXPECT_EQ(layers, 4);
    EXPECT_EQ(values.size(), 4u * (1 + 7));
    EXPECT_NEAR(mean("reflected_sky.S0.8500,000nm"), 5, 1e-5);
}

TEST_F(SplitPicture, standard_errors_are_those_of_the_whole_radiance) {
    const std::string options =
        std::string(from_above) + "-x 2 -y 2 -ab 2 -ad 1 -as 0 -aa 0 -dj 1 -spp 16 -lw 1e-6 ";
    folder.write("scene.rad", plate);
    const Outcome result = test::run(folder, "oconv scene.rad > scene.oct && rpict -w " + options +
                                                 "-se a.exr -o a2.exr scene.oct && rpict -w " + options +
                                                 "-se b.exr -split s.exr -o b2.exr scene.oct");
    ASSERT_EQ(result.status, 0) << result.err;
    const Picture plain = read_picture(folder.path("a.exr")), split = read_picture(folder.path("b.exr"));
    ASSERT_EQ(plain.pixels.size(), split.pixels.size());
    for (std::size_t i = 0; i < plain.pixels.size(); ++i)
        EXPECT_NEAR(plain.pixels[i], split.pixels[i], 1e-4F * plain.pixels[i] + 1e-6F);
}

TEST_F(SplitPicture, is_read_layer_by_layer) {
    render(plate, std::string(from_above) + "-ab 1 -ad 16 -as 0 -aa 0");
    const Outcome sun = test::run(folder, "irview -layer reflected_sun -c 2 -stats s.exr");
    EXPECT_EQ(sun.status, 0) << sun.err;
    EXPECT_NE(sun.out, test::run(folder, "irview -c 2 -stats s.exr").out);
    EXPECT_EQ(read_exr_layer(folder.path("s.exr"), "reflected_sun").pixels[2],
              values.at("reflected_sun.B")[0]);
    const Outcome moon = test::run(folder, "irview -layer moon -stats s.exr");
    EXPECT_EQ(moon.status, 1);
    EXPECT_NE(moon.err.find("layers: assumed, emitted, path, reflected_sea"), std::string::npos) << moon.err;
}

TEST_F(SplitPicture, refuses_what_it_cannot_do) {
    folder.write("scene.rad", plate);
    ASSERT_EQ(test::run(folder, "oconv scene.rad > scene.oct").status, 0);
    const auto error = [&](const std::string& options) {
        const Outcome result = test::run(folder, "rpict -w " + options + " scene.oct > p.hdr");
        EXPECT_EQ(result.status, 1);
        return result.err;
    };
    EXPECT_NE(error("-split s.hdr").find("OpenEXR"), std::string::npos);
    EXPECT_NE(error("-splitb 2").find("need -split"), std::string::npos);
    EXPECT_NE(error("-split s.exr -splitm moon paint").find("sky, sea, sun or ship"), std::string::npos);
    EXPECT_NE(error("-split s.exr -splitm sea ocean").find("\"ocean\""), std::string::npos);
    EXPECT_NE(error("-split s.exr -af f.amb").find("-af"), std::string::npos);
    EXPECT_NE(error("-split s.exr -splitb 5").find("components"), std::string::npos);
    EXPECT_FALSE(folder.has("s.exr"));
}

}  // namespace
}  // namespace infra
