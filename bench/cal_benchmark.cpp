// The 210-sample sky of lib/skyfuncs/hemisky.cal, evaluated once for each of many rays, against the same
// formula written in C++. The bar is a ratio of 2.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cal/evaluator.h"
#include "cal/ray_library.h"
#include "common/vec.h"

namespace {

constexpr std::size_t ray_count = 4096;

std::vector<infra::Vec3> random_directions() {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<infra::Vec3> directions(ray_count);
    for (auto& direction : directions)
        direction = infra::normalize({normal(random), normal(random), normal(random)});
    return directions;
}

std::array<double, 210> samples() {
    std::array<double, 210> values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 20 + static_cast<double>(i * 7919 % 101);
    return values;
}

[[gnu::noinline]] double handwritten_sky(const infra::Vec3& d, const std::array<double, 210>& values) {
    const double row = std::clamp(std::acos(std::clamp(d.y, -1., 1.)) * (18 / std::numbers::pi), 0., 9.);
    const double row0 = std::min(std::floor(row), 8.);
    const double turn = d.x * d.x + d.z * d.z > 0 ? std::atan2(d.z, -d.x) : 0;
    const double column = turn * (-10 / std::numbers::pi) + 10;
    const double column0 = std::clamp(std::floor(column), 0., 19.);
    const auto first = static_cast<std::size_t>(10 * column0 + row0);
    const double down = row - row0, round = column - column0;
    const auto along = [&](std::size_t i) { return (1 - down) * values[i] + down * values[i + 1]; };
    return (1 - round) * along(first) + round * along(first + 10);
}

void handwritten(benchmark::State& state) {
    const auto directions = random_directions();
    const auto values = samples();
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(handwritten_sky(directions[i++ % ray_count], values));
}
BENCHMARK(handwritten);

void evaluated(benchmark::State& state) {
    const auto directions = random_directions();
    const auto values = samples();
    infra::cal::Library library = infra::cal::make_ray_library();
    const auto context = library.load_function_file("skyfuncs/hemisky.cal", {});
    const auto skybr = library.compile("skybr", {}, context);
    infra::cal::Evaluator evaluator(library.link());
    infra::cal::Host host;
    host.reals = values;
    host.channel = [](const void* direction, int number) {
        return (*static_cast<const infra::Vec3*>(direction))[number - infra::cal::ray_direction];
    };
    std::size_t i = 0;
    for (auto _ : state) {
        host.self = &directions[i++ % ray_count];
        evaluator.next_clock();
        benchmark::DoNotOptimize(evaluator.evaluate(skybr, host));
    }
}
BENCHMARK(evaluated);

}  // namespace

BENCHMARK_MAIN();
