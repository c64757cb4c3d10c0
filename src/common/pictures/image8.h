// A small 8 bit picture for people to look at: what PNG files, legends and false colours are made of.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace infra {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Row 0 is the top.
struct Image8 {
    int width = 0;
    int height = 0;
    std::vector<Rgb8> pixels;

    Image8(int w, int h, Rgb8 fill = {0, 0, 0}) : width(w), height(h), pixels(std::size_t(w) * h, fill) {}
    Rgb8& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
    const Rgb8& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
    /// Sets a pixel, or nothing outside the image.
    void set(int x, int y, Rgb8 color) {
        if (x >= 0 && y >= 0 && x < width && y < height) at(x, y) = color;
    }
};

/// Copies `source` into `target` with its upper left corner at (x, y), clipped.
void paste(Image8& target, const Image8& source, int x, int y);

/// Writes a PNG file atomically; throws Error when that fails.
void write_png(const std::string& path, const Image8& image);

}  // namespace infra
