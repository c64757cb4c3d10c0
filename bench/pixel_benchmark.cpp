// Pixels of RADIANCE's pictures: to red, green, blue, exponent and back, and whole pictures with their run
// lengths, written to and read from memory.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "common/pictures/picture.h"
#include "common/pictures/rgbe.h"

namespace {

using namespace infra;

constexpr int width = 1024, height = 256;
constexpr std::int64_t pixel_count = std::int64_t{width} * height;

/// Neighbours are alike, as in a picture, with a grain of 1 % as ray tracing leaves it.
Picture smooth_picture() {
    std::mt19937 engine(1);
    std::normal_distribution<float> grain(1.0f, 0.01f);
    Picture picture{.width = width, .height = height};
    picture.pixels.reserve(3 * pixel_count);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (const float color : {30.0f, 25.0f, 20.0f})
                picture.pixels.push_back(color * grain(engine) *
                                         (1.2f + std::sin(0.01f * static_cast<float>(row + column))));
    return picture;
}

void count_pixels(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * pixel_count); }

void encode(benchmark::State& state) {
    const Picture picture = smooth_picture();
    for (auto _ : state)
        for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
            benchmark::DoNotOptimize(
                to_rgbe(picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]));
    count_pixels(state);
}
BENCHMARK(encode)->Unit(benchmark::kMillisecond);

void decode(benchmark::State& state) {
    const Picture picture = smooth_picture();
    std::vector<Rgbe> pixels;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
        pixels.push_back(to_rgbe(picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]));
    for (auto _ : state)
        for (const Rgbe& pixel : pixels) benchmark::DoNotOptimize(from_rgbe(pixel));
    count_pixels(state);
}
BENCHMARK(decode)->Unit(benchmark::kMillisecond);

/// A picture's file, in memory.
class FileBytes {
  public:
    explicit FileBytes(const Picture& picture) {
        std::FILE* const file = open_memstream(&bytes_, &size_);
        write_hdr(file, picture);
        std::fclose(file);
    }
    ~FileBytes() { std::free(bytes_); }
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::FILE* open() const { return fmemopen(bytes_, size_, "r"); }
    std::size_t size() const { return size_; }

  private:
    char* bytes_ = nullptr;
    std::size_t size_ = 0;
};

void write_picture(benchmark::State& state) {
    const Picture picture = smooth_picture();
    std::size_t size = 0;
    for (auto _ : state) {
        const FileBytes file(picture);
        benchmark::DoNotOptimize(size = file.size());
    }
    count_pixels(state);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
}
BENCHMARK(write_picture)->Unit(benchmark::kMillisecond);

void read_picture_file(benchmark::State& state) {
    const FileBytes bytes(smooth_picture());
    for (auto _ : state) {
        std::FILE* const file = bytes.open();
        benchmark::DoNotOptimize(read_hdr(file, "memory").pixels.data());
        std::fclose(file);
    }
    count_pixels(state);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(read_picture_file)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
