// Look-ups in tables of BRDFs, small and large: what a lobe ray and a light source ask. Viewers and
// directions are random, which is the worst case for the caches; a picture's neighbouring rays have
// neighbouring viewers.
#include <benchmark/benchmark.h>

#include <numbers>
#include <random>
#include <vector>

#include "nrlbrdf/models.h"
#include "nrlbrdf/sampler.h"
#include "nrlbrdf/spectral_table.h"
#include "nrlbrdf/table_set.h"

namespace {

using namespace infra;

constexpr std::size_t query_count = 1 << 16;
constexpr GridCounts grids[] = {{20, 20, 40}, {45, 90, 45}, {90, 360, 90}};

struct Query {
    Vec3 wo, wi;
    double u1, u2, u3;
};

std::vector<Query> random_queries() {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> uniform;
    const auto direction = [&] {
        const double cosine = std::sqrt(uniform(engine)), azimuth = 2 * std::numbers::pi * uniform(engine);
        const double sine = std::sqrt(1 - cosine * cosine);
        return Vec3{sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
    };
    std::vector<Query> queries(query_count);
    for (Query& q : queries)
        q = {direction(), direction(), uniform(engine), uniform(engine), uniform(engine)};
    return queries;
}

LoadedTable table_of(const GridCounts& counts, double slope, std::optional<WavelengthBand> band = {}) {
    return {
        std::make_shared<const BrdfTable>(tabulate(gaussian_lobe(0.1, 0.4, slope), counts)), band, {}, {}};
}

void evaluated(benchmark::State& state) {
    const auto queries = random_queries();
    const LoadedTable loaded = table_of(grids[state.range(0)], 0.2);
    std::size_t n = 0;
    for (auto _ : state) {
        const Query& q = queries[n++ % query_count];
        benchmark::DoNotOptimize(loaded.table->eval_lobe(q.wo, q.wi));
    }
}
BENCHMARK(evaluated)->DenseRange(0, 2);

void sampled(benchmark::State& state) {
    const auto queries = random_queries();
    const LoadedTable loaded = table_of(grids[state.range(0)], 0.2);
    const LobeSampler sampler(std::make_shared<const TableDistribution>(loaded.table), 0.2);
    std::size_t n = 0;
    for (auto _ : state) {
        const Query& q = queries[n++ % query_count];
        benchmark::DoNotOptimize(sampler.sample(q.wo, q.u1, q.u2, q.u3));
    }
}
BENCHMARK(sampled)->DenseRange(0, 2);

/// All channels of a set of so many bands at one geometry.
void evaluated_in_bands(benchmark::State& state) {
    const auto queries = random_queries();
    const auto bands = static_cast<int>(state.range(1));
    const Channels channels = Channels::spectral(bands, 8000, 12000);
    std::vector<LoadedTable> tables;
    for (int c = 0; c < bands; ++c)
        tables.push_back(table_of(grids[state.range(0)], 0.1 + 0.01 * c,
                                  WavelengthBand{channels.lower_nm(c) / 1000, channels.upper_nm(c) / 1000}));
    const SpectralTable spectral(tables, share_tables(channels, tables));
    tables.clear();
    Spectrum lobe(bands);
    std::size_t n = 0;
    for (auto _ : state) {
        const Query& q = queries[n++ % query_count];
        spectral.normalized_lobe(q.wo, q.wi, lobe);
        benchmark::DoNotOptimize(lobe);
    }
}
BENCHMARK(evaluated_in_bands)->ArgsProduct({{0, 2}, {3, 8, 24}});

}  // namespace

BENCHMARK_MAIN();
