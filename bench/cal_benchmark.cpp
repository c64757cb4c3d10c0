// The 210-sample sky of lib/skyfuncs/hemisky.cal, evaluated once for each of many rays, against the same
// formula written in C++. `ratio` lets both run by turns, and its counter `ratio` is the evaluated one's time
// over the other's; the bar is 2.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
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

class EvaluatedSky {
  public:
    EvaluatedSky() : skybr_(compile()), evaluator_(library_.link()) {
        host_.reals = values_;
        host_.channel = [](const void* direction, int number) {
            return (*static_cast<const infra::Vec3*>(direction))[number - infra::cal::ray_direction];
        };
    }
    double operator()(const infra::Vec3& direction) {
        host_.self = &direction;
        evaluator_.next_clock();
        return evaluator_.evaluate(skybr_, host_);
    }

  private:
    infra::cal::ExprId compile() {
        const auto context = library_.load_function_file("skyfuncs/hemisky.cal", {});
        return library_.compile("skybr", {}, context);
    }

    std::array<double, 210> values_ = samples();
    infra::cal::Library library_ = infra::cal::make_ray_library();
    infra::cal::ExprId skybr_;
    infra::cal::Evaluator evaluator_;
    infra::cal::Host host_;
};

void evaluated(benchmark::State& state) {
    const auto directions = random_directions();
    EvaluatedSky sky;
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(sky(directions[i++ % ray_count]));
}
BENCHMARK(evaluated);

double cpu_seconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void ratio(benchmark::State& state) {
    const auto directions = random_directions();
    const auto values = samples();
    EvaluatedSky sky;
    double by_hand = 0, by_text = 0;
    for (auto _ : state) {
        const double start = cpu_seconds();
        for (const auto& direction : directions) benchmark::DoNotOptimize(handwritten_sky(direction, values));
        const double between = cpu_seconds();
        for (const auto& direction : directions) benchmark::DoNotOptimize(sky(direction));
        by_hand += between - start;
        by_text += cpu_seconds() - between;
    }
    state.counters["ratio"] = by_text / by_hand;
}
BENCHMARK(ratio)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
