// Writing RADIANCE pictures, scanline by scanline.
#include <array>
#include <cerrno>
#include <cstring>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/picture.h"
#include "common/rgbe.h"

namespace infra {
namespace {

constexpr int shortest_coded = 17;     // narrower scanlines are written flat, as RADIANCE does
constexpr int longest_coded = 0x7fff;  // the length field has 15 bits
constexpr int shortest_run = 4;
constexpr int longest_run = 127;
constexpr int longest_literal = 128;

/// Number of equal bytes from `start`, at most longest_run.
int run_length(const std::uint8_t* bytes, int start, int end) {
    int length = 1;
    while (length < longest_run && start + length < end && bytes[start + length] == bytes[start]) ++length;
    return length;
}

void put_run(std::vector<std::uint8_t>& out, int length, std::uint8_t value) {
    out.push_back(static_cast<std::uint8_t>(128 + length));
    out.push_back(value);
}

/// Bytes before a long run: two or three equal ones make a run of their own, anything else is copied.
void put_literals(std::vector<std::uint8_t>& out, const std::uint8_t* bytes, int start, int end) {
    const int count = end - start;
    if (count > 1 && count < shortest_run && run_length(bytes, start, end) == count) {
        put_run(out, count, bytes[start]);
        return;
    }
    for (int chunk = 0; start < end; start += chunk) {
        chunk = std::min(longest_literal, end - start);
        out.push_back(static_cast<std::uint8_t>(chunk));
        out.insert(out.end(), bytes + start, bytes + start + chunk);
    }
}

/// Run length code of one component of a scanline.
void encode(std::vector<std::uint8_t>& out, const std::uint8_t* bytes, int count) {
    for (int done = 0; done < count;) {
        int run_start = done, length = 0;
        while (run_start < count) {
            length = run_length(bytes, run_start, count);
            if (length >= shortest_run) break;
            run_start += length;
        }
        put_literals(out, bytes, done, run_start);
        if (run_start < count) {
            put_run(out, length, bytes[run_start]);
            run_start += length;
        }
        done = run_start;
    }
}

void put(std::FILE* file, const void* bytes, std::size_t count) {
    if (std::fwrite(bytes, 1, count, file) != count)
        throw Error(std::string("cannot write picture: ") + std::strerror(errno), {}, Severity::system);
}

}  // namespace

HdrWriter::HdrWriter(std::FILE* file, const PictureHeader& header, int width, int height, ColorSpace space)
    : file_(file), width_(width), rows_left_(height) {
    if (width < 1 || height < 1) throw Error("a picture needs at least one pixel");
    std::string text = "#?RADIANCE\n";
    for (const std::string& line : header.lines) text += line + "\n";
    text += space == ColorSpace::xyz ? "FORMAT=32-bit_rle_xyze\n\n" : "FORMAT=32-bit_rle_rgbe\n\n";
    char resolution[64];
    std::snprintf(resolution, sizeof resolution, "-Y %8d +X %8d\n", height, width);
    text += resolution;
    put(file_, text.data(), text.size());
}

void HdrWriter::write_scanline(std::span<const float> rgb) {
    if (rows_left_ <= 0 || rgb.size() != std::size_t(width_) * 3)
        throw Error("scanline does not fit the picture", {}, Severity::internal);
    --rows_left_;
    buffer_.clear();
    if (width_ < shortest_coded || width_ > longest_coded) {
        for (std::size_t i = 0; i < rgb.size(); i += 3) {
            const Rgbe pixel = to_rgbe(rgb[i], rgb[i + 1], rgb[i + 2]);
            buffer_.insert(buffer_.end(), pixel.begin(), pixel.end());
        }
    } else {
        std::array<std::vector<std::uint8_t>, 4> planes;
        for (auto& plane : planes) plane.resize(width_);
        for (int x = 0; x < width_; ++x) {
            const Rgbe pixel = to_rgbe(rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2]);
            for (int c = 0; c < 4; ++c) planes[c][x] = pixel[c];
        }
        buffer_ = {2, 2, static_cast<std::uint8_t>(width_ >> 8), static_cast<std::uint8_t>(width_ & 255)};
        for (const auto& plane : planes) encode(buffer_, plane.data(), width_);
    }
    put(file_, buffer_.data(), buffer_.size());
}

void HdrWriter::finish() {
    if (rows_left_ != 0) throw Error("picture is missing scanlines", {}, Severity::internal);
    if (std::fflush(file_) != 0)
        throw Error(std::string("cannot write picture: ") + std::strerror(errno), {}, Severity::system);
}

void write_hdr(const std::string& path, const Picture& picture) {
    if (picture.channels != 3 && picture.channels != 1)
        throw Error(Location{path}, "an .hdr picture has 1 or 3 channels", "write .exr instead");
    AtomicFile file(path);
    HdrWriter writer(file.stream(), picture.header, picture.width, picture.height, picture.space);
    std::vector<float> row(std::size_t(picture.width) * 3);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::span<const float> pixel = picture.at(x, y);
            for (int c = 0; c < 3; ++c) row[3 * x + c] = pixel[picture.channels == 3 ? c : 0];
        }
        writer.write_scanline(row);
    }
    writer.finish();
    file.commit();
}

}  // namespace infra
