// The nrlbrdf material with tables of several bands: every channel of a spectral rendering is what a
// rendering of that channel's table alone gives.
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "scene_pieces.h"
#include "test_tables.h"

namespace infra {
namespace {

using test::degree;
using test::words;

const test::RaySpec view = test::view_of_plate(50 * degree, 0.4);

// Three channels of 8-9.5 um, in the order of channels: from 9.5 um down. Each band has a lobe of its own.
const Channels channels = Channels::spectral(3, 8000, 9500);
constexpr WavelengthBand bands[] = {{9, 9.5}, {8.5, 9}, {8, 8.5}};

BrdfFunction band_brdf(int channel) {
    switch (channel) {
        case 0:
            return gaussian_lobe(0.1, 0.6, 0.15);
        case 1:
            return phong_lobe(0.3, 0.4, 3);
        default:  // looks back where the light comes from, and where the others have nothing
            return [](double theta_i, double phi, double theta_r) {
                return 0.02 + std::max(0.0, std::cos(phi)) * std::sin(theta_i) * std::sin(theta_r) / 2;
            };
    }
}

class BandFiles {
  public:
    BandFiles() {
        std::string joined;
        for (int c = 0; c < 3; ++c) {
            write_table(path(c), tabulate(band_brdf(c), {19, 36, 19}), "", bands[c]);
            std::ifstream file(path(c));
            joined.append(std::istreambuf_iterator<char>(file), {});
        }
        std::ofstream(all()) << joined;
    }
    std::string path(int channel) const { return folder_ / ("band" + std::to_string(channel) + ".brdf"); }
    std::string all() const { return folder_ / "all.brdf"; }
    std::string each() const { return path(2) + " " + path(0) + " " + path(1); }

  private:
    test::TemporaryFolder folder_;
};

// Light from all about with a gradient, and a source that is sampled.
std::string surroundings() {
    return "void light lamp 0 0 3 40 40 40\nlamp source spot 0 0 4 -.6 -.3 .7 12\n"
           "void brightfunc gradient 2 1+Dz+.5*Dx . 0 0\ngradient glow sky_glow 0 0 4 1 1 1 0\n"
           "sky_glow source sky 0 0 4 0 0 1 180\n";
}

std::string plate(const std::string& files, int count, int nsamp = 16) {
    return words("void nrlbrdf m", count, files, "0 5 .9 .8 .7", nsamp, ".2", test::plate, surroundings());
}

struct ChannelMeans {
    test::Estimate of[3];
};

ChannelMeans seen(const std::string& rad, const Channels& as) {
    test::TracedScene scene(rad, test::bounce_settings(64), as);
    test::Mean means[3];
    for (int n = 0; n < 2000; ++n) {
        const Spectrum radiance = scene.radiance(view.origin, view.direction);
        for (int c = 0; c < 3; ++c) means[c].add(static_cast<double>(radiance[c]));
    }
    return {{means[0].estimate(), means[1].estimate(), means[2].estimate()}};
}

TEST(NrlBrdfBands, EveryChannelIsARenderingOfItsTable) {
    const BandFiles files;
    const ChannelMeans together = seen(plate(files.all(), 1), channels);
    const ChannelMeans one_file_each = seen(plate(files.each(), 3), channels);
    for (int c = 0; c < 3; ++c) {
        SCOPED_TRACE(words("channel", c));
        const ChannelMeans alone = seen(plate(files.path(c), 1), channels);
        EXPECT_LT(alone.of[c].error, 0.01 * alone.of[c].mean);
        EXPECT_LT(together.of[c].error, 0.02 * alone.of[c].mean);
        test::expect_same(together.of[c], alone.of[c]);
        EXPECT_EQ(together.of[c].mean, one_file_each.of[c].mean);
    }
}

TEST(NrlBrdfBands, ReflectsItsReflectanceInEveryChannel) {
    const BandFiles files;
    test::TracedScene scene(
        words("void nrlbrdf m 1", files.all(), "0 5 1 1 1 64 .2", test::plate, test::surrounding(1)),
        test::bounce_settings(16), channels);
    test::Mean means[3];
    for (int n = 0; n < 1000; ++n) {
        const Spectrum radiance = scene.radiance(view.origin, view.direction);
        for (int c = 0; c < 3; ++c) means[c].add(static_cast<double>(radiance[c]));
    }
    for (int c = 0; c < 3; ++c) {
        const BrdfTable table(tabulate(band_brdf(c), {19, 36, 19}));
        const test::Estimate estimate = means[c].estimate();
        EXPECT_NEAR(estimate.mean, table.reflectance_dh(-view.direction.z), 4 * estimate.error + 1e-6) << c;
        EXPECT_LT(estimate.error, 0.004) << c;
    }
}

// What a material reflects it does not emit: an enclosure of one temperature looks the same in every channel
// whatever its tables are.
TEST(NrlBrdfBands, AnEnclosureOfOneTemperatureShowsNoBands) {
    const BandFiles files;
    const std::string room = "\nvoid thermal black 0 0 3 300 8 9.5\nblack bubble room 0 0 4 0 0 0 50\n";
    test::TracedScene scene(words("void nrlbrdf paint 1", files.all(),
                                  "0 5 .9 .8 .7 64 .2\nvoid thermal m 1 paint 0 3 300 8 9.5") +
                                room + test::plate,
                            test::bounce_settings(4), channels);
    std::vector<test::Mean> means(3);
    for (int n = 0; n < 6000; ++n) {
        const Spectrum seen = scene.radiance(view.origin, view.direction);
        for (int c = 0; c < 3; ++c) means[static_cast<std::size_t>(c)].add(static_cast<double>(seen[c]));
    }
    test::TracedScene black("void thermal m 0 0 3 300 8 9.5" + test::plate, {}, channels);
    const Spectrum expected = black.radiance(view.origin, view.direction);
    for (int c = 0; c < 3; ++c)
        test::expect_close(means[static_cast<std::size_t>(c)].estimate(), static_cast<double>(expected[c]),
                           1e-3);
}

TEST(NrlBrdfBands, OneTableServesAllChannelsAsItServesRgb) {
    const BandFiles files;
    test::TracedScene spectral(plate(files.path(0), 1), test::bounce_settings(16), channels);
    test::TracedScene rgb(plate(files.path(0), 1), test::bounce_settings(16));
    for (int n = 0; n < 20; ++n) {
        const Spectrum a = spectral.radiance(view.origin, view.direction);
        const Spectrum b = rgb.radiance(view.origin, view.direction);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(a[c], b[c]);
    }
}

TEST(NrlBrdfBands, SaysOnceWhichChannelsHaveNoBand) {
    const BandFiles files;
    const std::string two =
        words("void nrlbrdf other 1", files.all(), "0 5 1 1 1 1 .2\nother sphere s 0 0 4 9 9 9 1\n");
    const test::TracedScene scene(two + plate(files.all(), 1), {}, Channels::spectral(6, 8000, 11000));
    ASSERT_EQ(scene.compiled().warnings().size(), 1U);
    EXPECT_EQ(scene.compiled().warnings()[0],
              files.all() +
                  ":1: no band for 3 of the 6 channels, between 9.5 and 11 um: they take the nearest one");
    const test::TracedScene fits(plate(files.all(), 1), {}, channels);
    EXPECT_TRUE(fits.compiled().warnings().empty());
}

TEST(NrlBrdfBands, NeedWavelengthsToRender) {
    const BandFiles files;
    for (const std::string& rad : {plate(files.all(), 1), plate(files.each(), 3)}) {
        try {
            const test::TracedScene scene(rad);
            ADD_FAILURE() << "three tables were taken for red, green and blue";
        } catch (const Error& error) {
            EXPECT_EQ(
                std::string(error.what()),
                "test.rad:1: nrlbrdf \"m\": 3 BRDF tables, each of a band, and no wavelengths to render "
                "(-cs and -cw choose spectral channels, or name one table)");
        }
    }
}

}  // namespace
}  // namespace infra
