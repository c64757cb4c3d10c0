// Writing RADIANCE pictures, scanline by scanline.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/pictures/picture.h"
#include "common/pictures/rgbe.h"
#include "common/pictures/spectral_header.h"

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

const char* format_name(ColorSpace space) {
    switch (space) {
        case ColorSpace::xyz:
            return "32-bit_rle_xyze";
        case ColorSpace::spectrum:
            return "Radiance_spectra";
        case ColorSpace::rgb:
            break;
    }
    return "32-bit_rle_rgbe";
}

bool fits_hdr(const Picture& picture) {
    return picture.bands || picture.channels == 3 || picture.channels == 1;
}
constexpr const char* misfit = "an .hdr picture has 1 or 3 channels, or bands of wavelengths";
constexpr const char* misfit_hint = "write .exr instead";

void put(std::FILE* file, const void* bytes, std::size_t count) {
    if (std::fwrite(bytes, 1, count, file) != count)
        throw Error(std::string("cannot write picture: ") + std::strerror(errno), {}, Severity::system);
}

}  // namespace

HdrWriter::HdrWriter(std::FILE* file, const PictureHeader& header, int width, int height, ColorSpace space,
                     int channels)
    : file_(file), width_(width), rows_left_(height), channels_(channels) {
    if (width < 1 || height < 1) throw Error("a picture needs at least one pixel");
    std::string text = "#?RADIANCE\n";
    for (const std::string& line : header.lines) text += line + "\n";
    text += std::string("FORMAT=") + format_name(space) + "\n\n";
    char resolution[64];
    std::snprintf(resolution, sizeof resolution, "-Y %8d +X %8d\n", height, width);
    text += resolution;
    put(file_, text.data(), text.size());
}

void HdrWriter::write_scanline(std::span<const float> values) {
    const std::size_t pixel_bytes = static_cast<std::size_t>(channels_) + 1;
    if (rows_left_ <= 0 || values.size() != std::size_t(width_) * channels_)
        throw Error("scanline does not fit the picture", {}, Severity::internal);
    --rows_left_;
    pixels_.resize(width_ * pixel_bytes);
    for (std::size_t x = 0; x < std::size_t(width_); ++x)
        to_common_exponent(values.subspan(x * channels_, channels_),
                           std::span(pixels_).subspan(x * pixel_bytes, pixel_bytes));
    const bool coded = channels_ == 3 && width_ >= shortest_coded && width_ <= longest_coded;
    if (coded) encode_scanline();
    const std::vector<std::uint8_t>& bytes = coded ? buffer_ : pixels_;
    put(file_, bytes.data(), bytes.size());
}

/// Run length code of pixels_, in buffer_: one component after the other.
void HdrWriter::encode_scanline() {
    buffer_ = {2, 2, static_cast<std::uint8_t>(width_ >> 8), static_cast<std::uint8_t>(width_ & 255)};
    std::vector<std::uint8_t> plane(width_);
    for (int c = 0; c < 4; ++c) {
        for (int x = 0; x < width_; ++x) plane[x] = pixels_[4 * std::size_t(x) + c];
        encode(buffer_, plane.data(), width_);
    }
}

void HdrWriter::finish() {
    if (rows_left_ != 0) throw Error("picture is missing scanlines", {}, Severity::internal);
    if (std::fflush(file_) != 0)
        throw Error(std::string("cannot write picture: ") + std::strerror(errno), {}, Severity::system);
}

void write_hdr(std::FILE* file, const Picture& picture) {
    if (!fits_hdr(picture)) throw Error(misfit, misfit_hint);
    PictureHeader header = picture.header;
    if (picture.bands) set_channel_lines(header, *picture.bands);
    const ColorSpace space = picture.bands                      ? ColorSpace::spectrum
                             : picture.space == ColorSpace::xyz ? ColorSpace::xyz
                                                                : ColorSpace::rgb;
    const int written = std::max(picture.channels, 3);
    HdrWriter writer(file, header, picture.width, picture.height, space, written);
    std::vector<float> row(std::size_t(picture.width) * written);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::span<const float> pixel = picture.at(x, y);
            for (int c = 0; c < written; ++c)
                row[std::size_t(x) * written + c] = pixel[picture.channels == 1 ? 0 : c];
        }
        writer.write_scanline(row);
    }
    writer.finish();
}

void write_hdr(const std::string& path, const Picture& picture) {
    if (!fits_hdr(picture)) throw Error(Location{path}, misfit, misfit_hint);
    AtomicFile file(path);
    try {
        write_hdr(file.stream(), picture);
    } catch (const Error& error) {
        throw Error(Location{path}, error.message(), error.hint(), error.severity());
    }
    file.commit();
}

}  // namespace infra
