#include "nrlbrdf/spectral_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "common/random.h"
#include "nrlbrdf/models.h"
#include "nrlbrdf/sampler.h"
#include "nrlbrdf/table_set.h"
#include "support/chi_square.h"
#include "tables.h"

namespace infra {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Four channels of 1 um: two bands alone, one of two halves, one again the last band. The lobes differ in
// width, and one looks the other way, so that each is zero, or all but, where another is not.
const Channels channels = Channels::spectral(4, 8000, 12000);

std::vector<LoadedTable> three_bands() {
    const GridCounts counts{16, 24, 13};
    const BrdfFunction backward = [](double theta_i, double phi, double theta_r) {
        return 0.05 + std::max(0.0, std::cos(phi)) * std::sin(theta_i) * std::sin(theta_r) / 3;
    };
    const auto make = [&](const BrdfFunction& f, double lo, double hi) {
        return LoadedTable{
            std::make_shared<const BrdfTable>(tabulate(f, counts)), WavelengthBand{lo, hi}, {}, {}};
    };
    return {make(gaussian_lobe(0.2, 0.5, 0.25), 11, 12), make(backward, 9.5, 11),
            make(phong_lobe(0.3, 0.4, 4), 8, 9.5)};
}

/// Channel c as a table of its own.
BrdfTable alone(const std::vector<LoadedTable>& tables, const TableShares& shares) {
    const GridShape& shape = tables[0].table->shape();
    BrdfGrid grid{shape.theta_i_count, shape.phi_count, shape.theta_r_count, shape.phi_origin, {}};
    for (int i = 0; i < shape.theta_i_count; ++i)
        for (int k = 0; k < shape.phi_count; ++k)
            for (int j = 0; j < shape.theta_r_count; ++j) {
                double f = 0;
                for (std::size_t t = 0; t < tables.size(); ++t)
                    f += shares[t] * static_cast<double>(tables[t].table->values()[shape.index(i, k, j)]);
                grid.values.push_back(static_cast<float>(f));
            }
    return BrdfTable(grid);
}

struct Fixture {
    std::vector<LoadedTable> tables = three_bands();
    ChannelShares shares = share_tables(channels, tables);
    SpectralTable spectral{tables, shares};
    std::vector<BrdfTable> single;
    Fixture() {
        for (const TableShares& own : shares.of_channel) single.push_back(alone(tables, own));
    }
};

TEST(SpectralTable, HasTheTableOfEachChannel) {
    const Fixture all;
    EXPECT_EQ(all.spectral.tint_count(), 4);
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> uniform;
    for (std::size_t c = 0; c < 4; ++c) {
        const int channel = static_cast<int>(c);
        EXPECT_NEAR(static_cast<double>(all.spectral.diffuse_reflectance()[channel]),
                    all.single[c].diffuse_reflectance(), 1e-7);
        Spectrum reflectance(4), lobe(4);
        for (int n = 0; n < 300; ++n) {
            const Vec3 wo = test::direction(uniform(engine) * 90 * degree, uniform(engine) * 360 * degree);
            const Vec3 wi = test::direction(uniform(engine) * 90 * degree, uniform(engine) * 360 * degree);
            all.spectral.lobe_reflectance_dh(wo.z, reflectance);
            all.spectral.normalized_lobe(wo, wi, lobe);
            const double expected = all.single[c].lobe_reflectance_dh(wo.z);
            EXPECT_NEAR(static_cast<double>(reflectance[channel]), expected, 1e-6);
            EXPECT_NEAR(static_cast<double>(lobe[channel]) * expected, all.single[c].eval_lobe(wo, wi), 2e-6);
        }
    }
}

TEST(SpectralTable, ItsMeanIsThatOfTheLobes) {
    const Fixture all;
    const BrdfTable& mean = *all.spectral.mean_lobe();
    EXPECT_EQ(mean.diffuse_reflectance(), 0);
    const GridShape& shape = mean.shape();
    for (int i = 0; i < shape.theta_i_count; ++i)
        for (int k = 0; k < shape.phi_count; ++k)
            for (int j = 0; j < shape.theta_r_count; ++j) {
                double sum = 0;
                for (const BrdfTable& one : all.single) sum += one.lobe_node(i, k, j);
                EXPECT_NEAR(mean.lobe_node(i, k, j), sum / 4, 1e-6);
            }
}

TEST(SpectralTable, ChannelsOfEqualSharesAreOneTint) {
    const auto tables = three_bands();
    const Channels many = Channels::spectral(8, 8000, 12000);  // half a um each: nothing is mixed
    EXPECT_EQ(SpectralTable(tables, share_tables(many, tables)).tint_count(), 3);
}

// Samples of the mean, each channel weighted by its own factor, follow every channel's lobe: their density is
// right (chi-square), and sums of weights by cells of directions are that lobe's integrals.
TEST(SpectralTable, SamplesOfTheMeanAreExactInEveryChannel) {
    const Fixture all;
    const auto distribution = std::make_shared<const TableDistribution>(all.spectral.mean_lobe());
    const LobeSampler sampler(distribution, 0.2);
    constexpr int samples = 200'000, cells = 8;
    for (const double theta : {20 * degree, 52 * degree, 83 * degree}) {
        SCOPED_TRACE(theta / degree);
        const Vec3 wo = test::direction(theta, 0.3);
        const auto result = test::chi_square_test(
            [&](double u1, double u2, double u3) { return sampler.sample(wo, u1, u2, u3); },
            [&](const Vec3& wi) { return sampler.pdf(wo, wi); }, {.samples = samples});
        EXPECT_EQ(result.fault, "");
        EXPECT_GT(result.p, test::sidak_level(1e-3, 3));

        const double mean_albedo = sampler.table().lobe_reflectance_dh(wo.z);
        struct Sums {
            double first = 0, second = 0;
        };
        Sums seen[4][cells], whole[4];
        const auto cell_of = [&](const Vec3& wi) {
            const double turns = (std::atan2(wi.y, wi.x) - 0.3) / (2 * std::numbers::pi);
            return std::min(cells - 1, static_cast<int>((turns - std::floor(turns)) * cells));
        };
        RandomStream random(7, static_cast<std::uint64_t>(theta * 1e6));
        Spectrum lobe(4);
        for (int n = 0; n < samples; ++n) {
            const double u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
            const LobeSample drawn = sampler.sample(wo, u1, u2, u3);
            if (drawn.weight <= 0) continue;
            all.spectral.normalized_lobe(wo, drawn.wi, lobe);
            const double mean = sampler.table().eval_lobe(wo, drawn.wi) / mean_albedo;
            for (int c = 0; c < 4; ++c) {
                const double weight = drawn.weight / mean_albedo * static_cast<double>(lobe[c]) / mean;
                for (Sums* sums : {&seen[c][cell_of(drawn.wi)], &whole[c]}) {
                    sums->first += weight;
                    sums->second += weight * weight;
                }
            }
        }
        for (std::size_t c = 0; c < 4; ++c) {
            const auto error = [](const Sums& s) {
                const double mean = s.first / samples;
                return std::sqrt((s.second / samples - mean * mean) / samples);
            };
            EXPECT_NEAR(whole[c].first / samples, 1, 4 * error(whole[c])) << "channel " << c;
            constexpr int polar = 450, azimuth = 30;
            for (int cell = 0; cell < cells; ++cell) {
                double expected = 0;
                for (int a = 0; a < polar; ++a)
                    for (int b = 0; b < azimuth; ++b) {
                        const double t = (a + 0.5) * 90 * degree / polar;
                        const double turn = (cell + (b + 0.5) / azimuth) / cells;
                        const Vec3 wi = test::direction(t, 0.3 + 2 * std::numbers::pi * turn);
                        expected += all.single[c].eval_lobe(wo, wi) * std::cos(t) * std::sin(t);
                    }
                expected *= 90 * degree / polar * 2 * std::numbers::pi / (azimuth * cells) /
                            all.single[c].lobe_reflectance_dh(wo.z);
                EXPECT_NEAR(seen[c][cell].first / samples, expected, 4.5 * error(seen[c][cell]) + 1e-4)
                    << "channel " << c << ", cell " << cell;
            }
        }
    }
}

TEST(SpectralTable, RefusesWhatNoMemoryShouldHold) {
    constexpr std::size_t nodes = 4 * 1'050'000;
    const BrdfGrid grid{2, nodes / 4, 2, 0, std::vector<float>(nodes, 0.1f)};
    const LoadedTable table{
        std::make_shared<const BrdfTable>(grid), WavelengthBand{8, 9}, {"big.brdf", 3}, {}};
    ChannelShares shares;
    for (int c = 0; c < 24; ++c) shares.of_channel.push_back({c / 24.0, 1 - c / 24.0});
    try {
        const SpectralTable refused({table, table}, shares);
        ADD_FAILURE() << "24 channels of 4.2 million values were taken";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "big.brdf:3: 4200000 values for each of 24 channels that differ are too many (at most "
                     "100000000 in all: take a smaller grid or fewer channels)");
    }
}

TEST(SpectralTable, AChannelWithoutLobeTakesNothing) {
    std::vector<LoadedTable> tables = three_bands();
    tables[0].table = std::make_shared<const BrdfTable>(tabulate(lambertian(0.4), {16, 24, 13}));
    const SpectralTable spectral(tables, share_tables(channels, tables));
    Spectrum lobe(4), reflectance(4);
    const Vec3 wo = test::direction(50 * degree, 0), wi = test::direction(40 * degree, 3);
    spectral.normalized_lobe(wo, wi, lobe);
    spectral.lobe_reflectance_dh(wo.z, reflectance);
    EXPECT_EQ(lobe[0], 0.0f);
    EXPECT_EQ(reflectance[0], 0.0f);
    EXPECT_GT(lobe[3], 0.0f);
    EXPECT_NEAR(static_cast<double>(spectral.diffuse_reflectance()[0]), 0.4, 1e-6);
}

}  // namespace
}  // namespace infra
