// Photon maps: files, searches compared with a look at every photon, and estimates compared with closed forms
// for evenly spread photons, whose distances are those of a Poisson process.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

#include "../common/test_files.h"
#include "estimate.h"
#include "photon_files.h"
#include "rt/photons/photon_density.h"
#include "rt/photons/photon_file.h"
#include "rt/photons/photon_maps.h"
#include "rt/photons/photon_search.h"

namespace infra {
namespace {

using test::error_of;
using test::flux_of;
using test::grey_flux;
using test::map_of;
using test::on_plane;

constexpr double pi = std::numbers::pi;

std::vector<Photon> random_photons(std::size_t count, std::uint64_t seed) {
    RandomStream random(seed, 0);
    std::vector<Photon> photons;
    const auto coordinate = [&] { return 2 * random.uniform() - 1; };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 position(coordinate(), coordinate(), 0.3 * coordinate());
        const Vec3 normal = normalize(Vec3(coordinate(), coordinate(), coordinate()));
        photons.push_back(test::photon(position, normal,
                                       grey_flux(static_cast<std::uint8_t>(random.uniform() * 256)),
                                       random.uniform() < 0.3));
    }
    return photons;
}

/// Mean of the estimate over its limit for many photons: the edge between the k-th and the next.
/// With q the share of the disk (or ball) of the next that the k-th encloses, q is Beta(k, 1) and independent
/// of its size G, which is Gamma(k + 1); E[k/G] = 1 and the edge gives (2 / (1 + q^(1/d)))^d. s: the d-th
/// root of q.
double mean_estimate(int k, int dimensions) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double s = (i + 0.5) / steps;
        sum += dimensions * k * std::pow(s, dimensions * k - 1) * std::pow(2 / (1 + s), dimensions) / steps;
    }
    return sum;
}

// Files
// -----------------------------------------------------------------------------------------------------

struct PhotonFile : testing::Test {
    test::TemporaryFolder folder;
    std::string path = folder / "test.pm";

    std::string bytes() const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void rewrite(const std::string& text) const { test::write_file(path, text); }
    void replace(const std::string& from, const std::string& to) const {
        std::string all = bytes();
        ASSERT_NE(all.find(from), std::string::npos);
        rewrite(all.replace(all.find(from), from.size(), to));
    }
    std::string complaint() const {
        return error_of([this] { read_photon_map(path); });
    }
};

TEST_F(PhotonFile, HoldsWhatWasWritten) {
    const std::vector<Photon> photons = random_photons(1000, 1);
    const char* const words[photon_kinds] = {"Global", "PreComp", "Caustic", "Volume", "Direct", "Contrib"};
    for (int kind = 0; kind < photon_kinds; ++kind) {
        test::write_photon_map(path, words[kind], photons, kind == 5 ? 33 : 0);
        const PhotonMap map = read_photon_map(path);
        EXPECT_EQ(map.kind(), static_cast<PhotonKind>(kind));
        EXPECT_EQ(map.size(), photons.size());
        EXPECT_NEAR(map.spread2(), test::spread2(photons), 1e-8);
        PhotonSearch search;
        for (const Photon& photon : photons) {
            const Vec3 place(photon.position[0], photon.position[1], photon.position[2]);
            search.find(map, PhotonQuery(place), 1, 1.0f);
            ASSERT_EQ(search.found().size(), 1u);
            EXPECT_LT(search.found()[0].distance2, 1e-14f);  // 31 bits of a position
            const PhotonMap::Attributes found = map.attributes(search.found()[0].place);
            EXPECT_EQ(found.flux(), photon.flux);
            EXPECT_EQ(found.is_caustic(), photon.is_caustic());
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(found.direction(i), photon.direction[static_cast<std::size_t>(i)]);
        }
    }
}

TEST_F(PhotonFile, CutOffAnywhereIsTruncated) {
    test::write_photon_map(path, "Global", random_photons(20, 2), 3);
    const std::string whole = bytes();
    EXPECT_EQ(complaint(), "no error");
    const std::size_t header = whole.find("\n\n") + 2;
    for (std::size_t length = header; length < whole.size(); ++length) {
        rewrite(whole.substr(0, length));
        ASSERT_EQ(complaint(), path + ": truncated photon map") << length;
    }
    for (std::size_t length = 0; length < header; ++length) {
        rewrite(whole.substr(0, length));
        ASSERT_EQ(complaint(), path + ": truncated photon map") << length;
    }
}

TEST_F(PhotonFile, SomethingElseIsRefused) {
    EXPECT_NE(complaint().find("cannot open photon map \"" + path + "\": No such file"), std::string::npos);
    rewrite("hello\n\n");
    EXPECT_EQ(complaint(), path + ": this is no photon map");
    rewrite("#?RADIANCE\n\n");
    EXPECT_EQ(complaint(), path + ": this is no photon map");
    rewrite("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n");
    EXPECT_EQ(complaint(), path + ": this is no photon map but a file of format 32-bit_rle_rgbe");
    rewrite("#?RADIANCE\nFORMAT=Radiance_Global_OOC_Photon_Map\n\n");
    EXPECT_NE(complaint().find("photons in an octree of pages are not supported"), std::string::npos);
    rewrite("#?RADIANCE\nFORMAT=Radiance_Solar_kdT_Photon_Map\n\n");
    EXPECT_NE(complaint().find("this is no photon map but"), std::string::npos);
}

TEST_F(PhotonFile, DamageIsNamed) {
    const std::vector<Photon> photons = random_photons(20, 3);
    const auto fresh = [&] { test::write_photon_map(path, "Global", photons); };
    fresh();
    const std::size_t body = bytes().find("\n\n") + 2;
    const auto overwrite = [&](std::size_t at, const std::string& with) {
        fresh();
        rewrite(bytes().replace(at, with.size(), with));
    };
    overwrite(body, "2.9k");
    EXPECT_EQ(complaint(),
              path + ": photon maps of version \"2.9k\" are not supported (this program reads 3.1k)");
    overwrite(body + 5, std::string(8, '\0'));
    EXPECT_EQ(complaint(), path + ": damaged photon map: 0 photons");
    overwrite(body + 5, "\xff");
    EXPECT_NE(complaint().find("damaged photon map: -"), std::string::npos);
    overwrite(body + 5, "\x7f");
    EXPECT_NE(complaint().find("damaged photon map: 9"), std::string::npos);
    overwrite(body + 9, "\x1f");  // far more photons than bytes, but not too many to ask for
    EXPECT_EQ(complaint(), path + ": truncated photon map");
    fresh();
    const std::size_t first_flags = bytes().size() - 19 * 27 - 1;
    overwrite(first_flags, "\x03");
    EXPECT_EQ(complaint(), path + ": damaged photon map: photon 1 divides space along no axis");
}

TEST_F(PhotonFile, AnyByteMayBeWrongWithoutHarm) {
    test::write_photon_map(path, "Contrib", random_photons(60, 4), 2);
    const std::string whole = bytes();
    RandomStream random(5, 0);
    PhotonSearch search;
    for (int round = 0; round < 400; ++round) {
        std::string damaged = whole;
        for (int k = 0; k < 4; ++k)
            damaged[static_cast<std::size_t>(random.uniform() * static_cast<double>(whole.size()))] =
                static_cast<char>(256 * random.uniform());
        rewrite(damaged);
        try {
            const PhotonMap map = read_photon_map(path);
            search.find(map, PhotonQuery(Vec3(0)).facing(Vec3(0, 0, 1)), 10, 1e30f);
            EXPECT_LE(search.found().size(), 10u);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
        }
    }
}

// Searches
// -----------------------------------------------------------------------------------------------------

TEST(PhotonSearch, FindsWhatALookAtAllFinds) {
    PhotonSearch search;
    RandomStream random(6, 0);
    for (const std::size_t count : {1, 2, 3, 7, 14, 15, 16, 17, 30, 31, 32, 33, 100, 255, 256, 1000, 5000}) {
        const std::vector<Photon> photons = random_photons(count, count);
        const PhotonMap map = map_of(PhotonKind::global, photons);
        for (int round = 0; round < 40; ++round) {
            const Vec3 point(3 * random.uniform() - 1.5, 2 * random.uniform() - 1, random.uniform() - 0.5);
            const Vec3 normal = normalize(Vec3(random.uniform() - 0.5, random.uniform() - 0.5, 0.1));
            const std::size_t most = 1 + static_cast<std::size_t>(60 * random.uniform());
            const auto limit2 = static_cast<float>(round % 3 ? 10 : random.uniform());
            PhotonQuery query(point);
            if (round % 2) query.facing(normal);
            query.caustic(round % 5 == 0);
            std::vector<float> expected;
            for (const Photon& photon : photons) {
                float distance2 = 0, facing = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    const float d = static_cast<float>(point[static_cast<int>(i)]) - photon.position[i];
                    distance2 += d * d;
                    facing += static_cast<float>(normal[static_cast<int>(i)]) * photon.direction[i];
                }
                const bool faces = round % 2 == 0 || facing > 1.27f;
                const bool wanted = round % 5 != 0 || photon.is_caustic();
                if (distance2 < limit2 && faces && wanted) expected.push_back(distance2);
            }
            std::sort(expected.begin(), expected.end());
            if (expected.size() > most) expected.resize(most);
            search.find(map, query, most, limit2);
            std::vector<float> found;
            for (const FoundPhoton& photon : search.found()) found.push_back(photon.distance2);
            if (!found.empty()) {
                EXPECT_EQ(found[0], *std::max_element(found.begin(), found.end()));
            }
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found.size(), expected.size()) << count << " photons, round " << round;
            for (std::size_t i = 0; i < found.size(); ++i) EXPECT_FLOAT_EQ(found[i], expected[i]);
            EXPECT_EQ(search.radius2(), found.size() == most ? found.back() : limit2);
        }
    }
}

TEST(PhotonSearch, EqualPhotonsAreAllThere) {
    const std::vector<Photon> photons(100, test::photon(Vec3(1, 2, 3), Vec3(0, 0, 1), grey_flux(1)));
    const PhotonMap map = map_of(PhotonKind::global, photons);
    PhotonSearch search;
    search.find(map, PhotonQuery(Vec3(1, 2, 3)), 200, 1.0f);
    EXPECT_EQ(search.found().size(), 100u);
    search.find(map, PhotonQuery(Vec3(1, 2, 4)), 10, 2.0f);
    EXPECT_EQ(search.found().size(), 10u);
    EXPECT_EQ(search.radius2(), 1.0f);
}

// Estimates
// -----------------------------------------------------------------------------------------------------

/// Means of estimates at places of a plane of evenly spread photons, each trial with photons of its own.
test::Estimate plane_estimate(int fewest, int most) {
    constexpr std::size_t count = 4000;
    test::Mean mean;
    PhotonDensity density;
    RandomStream random(8, 1);
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
        std::vector<Photon> photons =
            on_plane({0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, count, grey_flux(99), trial);
        const auto below =
            on_plane({0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, -1}, count, grey_flux(200), trial + 1000);
        photons.insert(photons.end(), below.begin(), below.end());
        const PhotonSource source{map_of(PhotonKind::global, photons), fewest, most, 4.0f};
        for (int i = 0; i < 36; ++i) {  // the disks of 40 photons do not overlap
            const Vec3 place(0.5 + i % 6 * 0.2, 0.5 + i / 6 * 0.2, 1);
            mean.add(density.surface(source, place, {0, 0, 1}, false, random)[1]);
        }
    }
    test::Estimate estimate = mean.estimate();
    const double exact = flux_of(grey_flux(99)) * count / 4 / pi;
    return {estimate.mean / exact, estimate.error / exact};
}

TEST(PhotonDensity, OfAPlane) {
    for (const int k : {2, 5, 40}) test::expect_close(plane_estimate(k, k), mean_estimate(k, 2), 0.05);
}

TEST(PhotonDensity, OfAPlaneWithBiasCompensation) {
    // Somewhere between what the fewest and the most photons give, plus what the choice favours.
    const test::Estimate estimate = plane_estimate(10, 40);
    EXPECT_NEAR(estimate.mean, 1, 0.05);
    EXPECT_LT(estimate.error, plane_estimate(10, 10).error);
}

TEST(PhotonDensity, CompensationKeepsEdges) {
    // Bright for x < 0, dark beyond; at 0.02 from the edge, where 800 photons reach 0.16.
    const auto photons = on_plane({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}, 20000, grey_flux(99), 5);
    const double exact = flux_of(grey_flux(99)) * 20000 / 2 / pi;
    PhotonDensity density;
    RandomStream random(9, 0);
    const auto error = [&](int fewest, int most) {
        const PhotonSource source{map_of(PhotonKind::global, photons), fewest, most, 4.0f};
        double sum = 0;
        for (int i = 0; i < 100; ++i)
            sum += density.surface(source, {-0.02, -0.5 + 0.01 * i, 0}, {0, 0, 1}, false, random)[0] / exact /
                   100;
        return 1 - sum;
    };
    EXPECT_GT(error(800, 800), 0.35);
    EXPECT_LT(error(20, 800), 0.5 * error(800, 800));
}

TEST(PhotonDensity, TooFewWithinTheRadius) {
    // The radius then counts as the farthest photon, which no photon stands for.
    std::vector<Photon> photons;
    for (const double x : {0.1, 0.2, 0.3})
        photons.push_back(test::photon({x, 0, 0}, {0, 0, 1}, grey_flux(64)));
    const PhotonMap map = map_of(PhotonKind::caustic, photons);
    PhotonDensity density;
    RandomStream random(1, 0);
    const double radius = (0.5 + 0.2) / 2;
    EXPECT_NEAR(density.surface({map, 40, 40, 0.25f}, Vec3(0), {0, 0, 1}, false, random)[0],
                2 * flux_of(grey_flux(64)) / (pi * pi * radius * radius), 1e-9);
    EXPECT_EQ(density.surface({map, 40, 40, 0.02f}, Vec3(0), {0, 0, 1}, false, random)[0], 0);
    EXPECT_EQ(density.surface({map, 40, 40, 0.25f}, Vec3(0), {0, 0, -1}, false, random)[0], 0);
}

TEST(PhotonDensity, PrecomputedIsThatOfTheNearest) {
    std::vector<Photon> photons;
    photons.push_back(test::photon({0.1, 0, 0}, {1, 0, 0}, grey_flux(10)));
    photons.push_back(test::photon({0.2, 0, 0}, {0, 0, 1}, grey_flux(20)));
    photons.push_back(test::photon({0.3, 0, 0}, {0, 0, 1}, grey_flux(30)));
    const PhotonSource source{map_of(PhotonKind::precomputed, photons), 1, 1, 1.0f};
    PhotonDensity density;
    RandomStream random(1, 0);
    EXPECT_EQ(density.surface(source, Vec3(0), {0, 0, 1}, false, random)[0], flux_of(grey_flux(20)));
}

TEST(PhotonDensity, OfAVolume) {
    constexpr std::size_t count = 20000;
    PhotonDensity density;
    for (const double g : {0.0, 0.4}) {
        test::Mean mean;
        for (std::uint64_t trial = 0; trial < 25; ++trial) {
            RandomStream random(trial, 3);
            std::vector<Photon> photons;
            for (std::size_t i = 0; i < count; ++i) {
                const double x = random.uniform(), y = random.uniform(), z = random.uniform();
                photons.push_back(test::photon({x, y, z}, {0, 0.6, 0.8}, grey_flux(99)));
            }
            const PhotonSource source{map_of(PhotonKind::volume, photons), 30, 30, 4.0f};
            for (int i = 0; i < 64; ++i)
                mean.add(density.volume(source,
                                        {0.2 + i % 4 * 0.2, 0.2 + i / 4 % 4 * 0.2, 0.2 + i / 16 * 0.2},
                                        {0, 0, -1}, g)[2]);
        }
        const Photon sample = test::photon(Vec3(0), {0, 0.6, 0.8}, grey_flux(99));
        const double cosine = sample.direction[2] / 127.0;  // rounded to 8 bits; they go towards the eye
        const double phase = (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        test::expect_close(mean.estimate(), phase * flux_of(grey_flux(99)) * count * mean_estimate(30, 3),
                           0.03);
    }
}

// Sets of maps
// -----------------------------------------------------------------------------------------------------

struct PhotonSet : testing::Test {
    test::TemporaryFolder folder;
    std::vector<std::string> warnings;

    std::string make(const std::string& word, std::size_t count = 100) {
        const std::string path = folder / word;
        test::write_photon_map(path, word, random_photons(count, 1));
        return path;
    }
    PhotonMaps read(std::vector<PhotonMapRequest> requests, double radius = 0) {
        RenderSettings settings;
        settings.photon_maps = std::move(requests);
        settings.photon_radius = radius;
        return {settings, warnings};
    }
};

TEST_F(PhotonSet, KindsAndTheirOrder) {
    const std::string global = make("Global"), precomputed = make("PreComp"), caustic = make("Caustic"),
                      contribution = make("Contrib"), volume = make("Volume");
    PhotonMaps maps = read({{global, 20, 20}, {caustic, 30, 30}});
    EXPECT_EQ(maps.indirect()->photons.kind(), PhotonKind::global);
    EXPECT_EQ(maps.caustic()->most, 30);
    EXPECT_TRUE(maps.cover_surfaces());
    EXPECT_TRUE(maps.cover_transmitted_light());
    EXPECT_FALSE(maps.volume() || maps.direct());
    EXPECT_FALSE(read({{global, 20, 20}}).cover_transmitted_light());
    EXPECT_EQ(read({{global, 20, 20}, {precomputed}}).indirect()->photons.kind(), PhotonKind::precomputed);
    maps = read({{contribution, 20, 20}, {global, 9, 9}, {caustic, 20, 20}});
    EXPECT_EQ(maps.indirect()->photons.kind(), PhotonKind::contribution);
    EXPECT_EQ(maps.caustic()->photons.kind(), PhotonKind::contribution);
    EXPECT_FALSE(read({{volume, 20, 20}}).cover_surfaces());
    EXPECT_TRUE(warnings.empty());
}

TEST_F(PhotonSet, CountsAndRadii) {
    const std::string global = make("Global"), precomputed = make("PreComp"), volume = make("Volume");
    PhotonMaps maps = read({{global, 0, 0}});
    EXPECT_EQ(maps.indirect()->most, 40);
    EXPECT_EQ(warnings, std::vector{global + ": no bandwidth given, 40 photons are looked up"});
    EXPECT_FLOAT_EQ(maps.indirect()->limit2,
                    static_cast<float>(100 * 41 * test::spread2(random_photons(100, 1)) / 100));
    EXPECT_FLOAT_EQ(read({{global, 5, 9}}, 0.5).indirect()->limit2, 0.25f);
    warnings.clear();
    maps = read({{global, 50, 200}});
    EXPECT_EQ(maps.indirect()->fewest, 99);
    EXPECT_EQ(maps.indirect()->most, 99);
    EXPECT_EQ(warnings, std::vector{global + ": only 100 photons for a bandwidth of 200"});
    warnings.clear();
    read({{precomputed, 50, 50}});
    EXPECT_EQ(warnings.size(), 1u);
    warnings.clear();
    read({{global, 50, 50}, {global, 20, 20}});
    EXPECT_EQ(warnings, std::vector{global + ": replaces another global photon map"});
    EXPECT_EQ(error_of([&] {
                  read({{volume, 20, 30}});
              }),
              volume + ": bias compensation is not available for a volume map (give one bandwidth)");
}

}  // namespace
}  // namespace infra
