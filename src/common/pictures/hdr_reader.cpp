// Reading RADIANCE pictures: flat pixels, old and new run lengths, spectra, any order of scanlines.
#include <algorithm>
#include <cstring>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/pictures/picture.h"
#include "common/pictures/rgbe.h"
#include "common/pictures/scan_order.h"
#include "common/pictures/spectral_header.h"

namespace infra {
namespace {

constexpr std::size_t longest_header = 1 << 22;  // bytes
constexpr long long longest_scanline = 1 << 26;  // bytes
constexpr int most_channels = 4096;
constexpr long long most_values = 1LL << 30;

class HdrReader {
  public:
    HdrReader(std::FILE* file, const std::string& name) : file_(file), name_(name) {}

    Picture read() {
        Picture picture;
        const ScanOrder size = read_start(picture);
        const int length = size.scanline_length(), count = size.scanline_count();
        std::vector<float> scans;  // grows with what the file really holds
        std::vector<std::uint8_t> bytes(std::size_t(length) * (picture.channels + 1));
        for (scanline_ = 0; scanline_ < count; ++scanline_) {
            read_scanline(bytes, length, picture.channels);
            append_floats(scans, bytes, picture.channels);
        }
        picture.pixels = in_standard_order(std::move(scans), size, picture.channels);
        return picture;
    }

    UnfinishedRows read_unfinished() {
        UnfinishedRows result;
        Picture& picture = result.rows;
        const ScanOrder size = read_start(picture);
        if (!size.is_standard()) fail("its scanlines do not run from the top", "it cannot be finished");
        result.height = size.height;
        std::vector<std::uint8_t> bytes(std::size_t(size.width) * (picture.channels + 1));
        try {
            for (scanline_ = 0; scanline_ < size.height; ++scanline_) {
                read_scanline(bytes, size.width, picture.channels);
                append_floats(picture.pixels, bytes, picture.channels);
            }
        } catch (const Error&) {  // here is its end
        }
        picture.height = scanline_;
        return result;
    }

  private:
    /// Everything before the pixels.
    ScanOrder read_start(Picture& picture) {
        read_header(picture);
        const ScanOrder size = read_order();
        picture.width = size.width;
        picture.height = size.height;
        if (1LL * size.width * size.height > most_values / picture.channels)
            fail("bad picture: it is larger than we can hold");
        if (1LL * size.scanline_length() * (picture.channels + 1) > longest_scanline)
            fail("bad picture: its scanlines are longer than we can hold");
        return size;
    }

    [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const {
        throw Error(Location{name_}, what, hint);
    }
    [[noreturn]] void fail_scanline(const std::string& what) const {
        fail(formatted("bad picture: scanline %d ", scanline_ + 1) + what);
    }

    int byte() {
        const int c = getc_unlocked(file_);
        if (c == EOF) fail_scanline("is cut short");
        return c;
    }

    /// One line without its end; false at the end of file.
    bool line(std::string& text) {
        text.clear();
        int c;
        while ((c = getc_unlocked(file_)) != EOF && c != '\n') {
            text += static_cast<char>(c);
            if (text.size() > longest_header) fail("not a picture: its header does not end");
        }
        return c != EOF;
    }

    void read_header(Picture& picture) {
        std::string text;
        if (!line(text) || !text.starts_with("#?"))
            fail("not a RADIANCE picture", "it does not start with \"#?\"");
        std::string format = "32-bit_rle_rgbe";
        std::size_t size = 0;
        for (;;) {
            if (!line(text)) fail("bad picture: the header is cut short");
            if (!text.empty() && text.back() == '\r') text.pop_back();
            if (text.empty()) break;
            if ((size += text.size()) > longest_header) fail("not a picture: its header does not end");
            if (text.starts_with("FORMAT=")) {
                const auto words = split_words(std::string_view(text).substr(7));
                format = words.empty() ? "" : words[0];
            } else {
                picture.header.add(text);
            }
        }
        if (format == "32-bit_rle_xyze") {
            picture.space = ColorSpace::xyz;
        } else if (format == "Radiance_spectra") {
            picture.space = ColorSpace::spectrum;
            const std::string count = picture.header.value("NCOMP").value_or("");
            if (!parse_int(count, picture.channels) || picture.channels < 3 ||
                picture.channels > most_channels)
                fail("bad picture: a spectral one needs NCOMP= and a number from 3 to 4096");
            picture.bands = channels_of(picture.header, picture.channels);
        } else if (format != "32-bit_rle_rgbe") {
            fail("unknown picture format \"" + format + "\"",
                 "known are 32-bit_rle_rgbe, 32-bit_rle_xyze and Radiance_spectra");
        }
    }

    ScanOrder read_order() {
        std::string text;
        const auto order = line(text) ? parse_scan_order(text) : std::nullopt;
        if (order) return *order;
        if (is_resolution_line(text)) fail("bad picture: illegal resolution \"" + text + "\"");
        fail("bad picture: no resolution line such as \"-Y 480 +X 640\"");
    }

    void read_scanline(std::vector<std::uint8_t>& bytes, int length, int channels) {
        if (channels > 3) {
            for (std::uint8_t& value : bytes) value = static_cast<std::uint8_t>(byte());
            return;
        }
        for (int c = 0; c < 4; ++c) bytes[c] = static_cast<std::uint8_t>(byte());
        if (bytes[0] != 2 || bytes[1] != 2 || (bytes[2] & 0x80)) {
            read_old_scanline(bytes, length);
        } else {
            if (bytes[2] * 256 + bytes[3] != length) fail_scanline("has the wrong length");
            for (int c = 0; c < 4; ++c) read_component(bytes, c, length);
        }
    }

    /// One component in new run lengths: counts above 128 repeat a byte, others copy that many.
    void read_component(std::vector<std::uint8_t>& bytes, int component, int length) {
        for (int x = 0; x < length;) {
            const int code = byte();
            const bool is_run = code > 128;
            const int count = is_run ? code - 128 : code;
            if (count == 0 || x + count > length) fail_scanline("is malformed: a run does not fit");
            const int repeated = is_run ? byte() : 0;
            for (int i = 0; i < count; ++i, ++x)
                bytes[4 * x + component] = static_cast<std::uint8_t>(is_run ? repeated : byte());
        }
    }

    /// Flat pixels or old run lengths after a first pixel: (1, 1, 1, n) repeats the pixel before it; several
    /// in a row are the digits of the count, base 256, least first. A count that runs past the end is cut
    /// off, as RADIANCE does.
    void read_old_scanline(std::vector<std::uint8_t>& bytes, int length) {
        int shift = 0;
        for (int x = 1; x < length;) {
            std::uint8_t* pixel = &bytes[4 * std::size_t(x)];
            for (int c = 0; c < 4; ++c) pixel[c] = static_cast<std::uint8_t>(byte());
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                ++x;
                shift = 0;
                continue;
            }
            if (shift > 24) fail_scanline("is malformed: a repeat count does not end");
            const long long count = static_cast<long long>(pixel[3]) << shift;
            const int repeats = static_cast<int>(std::min<long long>(count, length - x));
            const Rgbe before{pixel[-4], pixel[-3], pixel[-2], pixel[-1]};
            for (int i = 0; i < repeats; ++i) std::ranges::copy(before, pixel + 4 * std::size_t(i));
            x += repeats;
            shift += 8;
        }
    }

    static void append_floats(std::vector<float>& scans, const std::vector<std::uint8_t>& bytes,
                              int channels) {
        for (std::size_t i = 0; i < bytes.size(); i += channels + 1) {
            const float factor = rgbe_factor(bytes[i + channels]);
            for (int c = 0; c < channels; ++c) scans.push_back((bytes[i + c] + 0.5f) * factor);
        }
    }

    static std::vector<float> in_standard_order(std::vector<float> scans, const ScanOrder& order,
                                                int channels) {
        if (order.is_standard()) return scans;
        std::vector<float> pixels(scans.size());
        std::size_t from = 0;
        for (int scan = 0; scan < order.scanline_count(); ++scan) {
            for (int step = 0; step < order.scanline_length(); ++step, from += channels) {
                const PixelPlace place = order.place(scan, step);
                const std::size_t to = std::size_t(place.row) * order.width + place.column;
                std::copy_n(&scans[from], channels, &pixels[to * channels]);
            }
        }
        return pixels;
    }

    std::FILE* file_;
    const std::string& name_;
    int scanline_ = 0;
};

}  // namespace

Picture read_hdr(std::FILE* file, const std::string& name) { return HdrReader(file, name).read(); }

UnfinishedRows read_unfinished_hdr(std::FILE* file, const std::string& name) {
    return HdrReader(file, name).read_unfinished();
}

}  // namespace infra
