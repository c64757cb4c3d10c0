// Text of numbers, in bytes a second: the readers of single numbers beside strtod of the C library, numbers
// of data files, and scene text.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "common/number_text.h"
#include "common/parse_number.h"
#include "common/short_number.h"
#include "scene/rad_reader.h"

namespace {

using namespace infra;

constexpr int number_count = 100000;

/// Numbers of so many digits behind the point, each followed by a blank.
std::string numbers(int digits) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-120, 120);
    std::string text;
    char word[40];
    for (int i = 0; i < number_count; ++i) {
        std::snprintf(word, sizeof word, "%.*f ", digits, uniform(engine));
        text += word;
    }
    return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find(' ', at);
        words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

void count_bytes(benchmark::State& state, const std::string& text) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.SetItemsProcessed(state.iterations() * number_count);
}

/// Up to 7 digits, as most numbers of large scenes have.
void short_numbers(benchmark::State& state) {
    const std::string text = numbers(3) + "        ";  // it reads eight characters at a time
    for (auto _ : state) {
        double value = 0;
        const char* at = text.data();
        for (int i = 0; i < number_count; ++i) {
            const std::size_t left = text.size() - static_cast<std::size_t>(at - text.data());
            const std::size_t size = parse_short_number({at, left}, value);
            if (size == 0) return state.SkipWithError("a number that is not short");
            benchmark::DoNotOptimize(value);
            at += size + 1;
        }
    }
    count_bytes(state, text);
}
BENCHMARK(short_numbers)->Unit(benchmark::kMillisecond);

void strict_numbers(benchmark::State& state) {
    const std::string text = numbers(static_cast<int>(state.range(0)));
    const auto words = words_of(text);
    for (auto _ : state)
        for (const std::string_view word : words) {
            double value = 0;
            if (!parse_real(word, value)) return state.SkipWithError("not a number");
            benchmark::DoNotOptimize(value);
        }
    count_bytes(state, text);
}
BENCHMARK(strict_numbers)->Arg(3)->Arg(12)->ArgName("digits")->Unit(benchmark::kMillisecond);

void c_library(benchmark::State& state) {
    const std::string text = numbers(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        char* end = nullptr;
        for (const char* at = text.c_str(); *at; at = end + 1)
            benchmark::DoNotOptimize(std::strtod(at, &end));
    }
    count_bytes(state, text);
}
BENCHMARK(c_library)->Arg(3)->Arg(12)->ArgName("digits")->Unit(benchmark::kMillisecond);

void data_file(benchmark::State& state) {
    const std::string text = numbers(static_cast<int>(state.range(0))), name = "memory";
    for (auto _ : state) {
        NumberText reader(text, name);
        while (!reader.at_end()) benchmark::DoNotOptimize(reader.real("a number"));
    }
    count_bytes(state, text);
}
BENCHMARK(data_file)->Arg(3)->Arg(12)->ArgName("digits")->Unit(benchmark::kMillisecond);

/// Triangles with coordinates of so many digits behind the point, into a Scene.
void scene_text(benchmark::State& state) {
    const std::string text = numbers(static_cast<int>(state.range(0)));
    const auto words = words_of(text);
    std::string rad = "void plastic paint 0 0 5 .5 .5 .5 0 0\n";
    for (std::size_t i = 0; i + 9 <= words.size(); i += 9) {
        rad += "paint polygon t" + std::to_string(i / 9) + " 0 0 9";
        for (std::size_t k = 0; k < 9; ++k) rad.append(" ").append(words[i + k]);
        rad += '\n';
    }
    for (auto _ : state) {
        Scene scene;
        read_rad_text(scene, rad, "memory", no_warnings());
        benchmark::DoNotOptimize(scene.size());
    }
    count_bytes(state, rad);
}
BENCHMARK(scene_text)->Arg(3)->Arg(12)->ArgName("digits")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
