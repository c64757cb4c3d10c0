#include "rt/programs/partial_frame.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "rt/programs/view_numbers.h"

namespace infra {
namespace {

constexpr const char* format_line = "FORMAT=rpict_partial";
constexpr std::string_view fingerprint_key = "FINGERPRINT= ";
constexpr std::uint32_t magic = 0x50415254;  // other in the other byte order
constexpr std::uint32_t version = 3;
constexpr std::size_t longest_header = 1 << 22;  // bytes

/// The numbers before the values.
struct Preamble {
    std::uint32_t magic = infra::magic;
    std::uint32_t version = infra::version;
    std::int32_t width = 0, height = 0;
    std::int32_t channels = 0, space = 0, has_depth = 0, has_error = 0;
    std::int32_t finished_rows = 0, finished_channels = 0, finished_space = 0;
    std::int32_t components = 1;
};
static_assert(std::is_trivially_copyable_v<Preamble>);

template <class Values>
void put(std::FILE* file, const Values& values) {
    if (!values.empty()) std::fwrite(values.data(), sizeof values[0], values.size(), file);
}

class PartialReader {
  public:
    explicit PartialReader(const std::string& path)
        : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose) {
        if (!file_)
            throw Error("cannot read \"" + path + "\": " + std::strerror(errno), {}, Severity::system);
    }

    /// Passes over the header; whether it is one of ours.
    bool read_header() {
        bool ours = false;
        std::size_t size = 0;
        for (std::string line; read_line(line) && !line.empty() && size < longest_header;) {
            if (size == 0 && !line.starts_with("#?")) return false;
            size += line.size();
            ours = ours || line == format_line;
            if (line.starts_with(fingerprint_key)) fingerprint_ = line.substr(fingerprint_key.size());
        }
        std::string resolution;
        return ours && read_line(resolution);
    }

    const std::string& fingerprint() const { return fingerprint_; }

    PartialFrame read(const Channels& channels) {
        if (!read_header()) fail("it does not begin as one");
        Preamble start;
        get(&start, 1);
        if (start.magic != magic || start.version != version)
            fail("another version of rpict, or another kind of machine, has made it");
        check(start);
        const ColorSpace space = channels.is_rgb() ? ColorSpace::rgb : ColorSpace::spectrum;
        if (start.channels != channels.count() || start.components != channels.components() ||
            start.space != static_cast<int>(space))
            throw Error(Location{path_}, "its channels are not those that -cs, -cw and -split ask for",
                        "finish it with the options it was begun with");
        PartialFrame partial;
        partial.fingerprint = fingerprint_;
        ViewNumbers view;
        get(view.data(), view.size());
        get(&partial.pixel_aspect, 1);
        const std::optional<View> found = view_of(view);
        if (!found || !std::isfinite(partial.pixel_aspect) || partial.pixel_aspect < 0)
            fail("there is no view in it");
        partial.view = *found;
        partial.width = start.width;
        partial.height = start.height;
        read_rows(start, partial.finished_rows);
        read_frame(start, partial.frame);
        if (std::fgetc(file_.get()) != EOF) fail("it goes on after its end");
        return partial;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Location{path_}, "bad unfinished picture: " + why);
    }

    bool read_line(std::string& line) {
        line.clear();
        int c;
        while ((c = std::fgetc(file_.get())) != EOF && c != '\n') {
            line += static_cast<char>(c);
            if (line.size() > longest_header) return false;
        }
        return c != EOF;
    }

    template <class T>
    void get(T* values, std::size_t count) {
        if (std::fread(values, sizeof(T), count, file_.get()) != count) fail("it is cut short");
    }

    void check(const Preamble& p) const {
        constexpr std::int64_t most_pixels = 1'000'000'000;
        constexpr int most_channels = 4096;
        const auto in = [](int value, int least, int most) { return value >= least && value <= most; };
        const int spaces = static_cast<int>(ColorSpace::spectrum);
        if (p.width < 1 || p.height < 1 || std::int64_t(p.width) * p.height > most_pixels ||
            !in(p.channels, 1, most_channels) || !in(p.components, 1, p.channels) ||
            p.channels % p.components != 0 || !in(p.finished_channels, 0, most_channels) ||
            !in(p.finished_rows, 0, p.height) || !in(p.space, 0, spaces) || !in(p.finished_space, 0, spaces))
            fail("its numbers make no sense");
    }

    /// Memory grows with what the file holds, whatever it says.
    template <class T>
    void read_values(std::vector<T>& values, std::size_t count) {
        constexpr std::size_t portion = 1 << 22;
        while (values.size() < count) {
            const std::size_t old = values.size(), more = std::min(portion, count - old);
            values.resize(old + more);
            get(values.data() + old, more);
        }
    }

    void read_rows(const Preamble& start, Picture& rows) {
        rows.width = start.width;
        rows.height = start.finished_rows;
        rows.channels = start.finished_channels;
        rows.space = static_cast<ColorSpace>(start.finished_space);
        read_values(rows.pixels, std::size_t(rows.width) * rows.height * rows.channels);
    }

    /// Whether the file holds what follows for so many pixels, before there is memory for them.
    void require_values(const Preamble& start, std::size_t pixels) {
        const std::size_t bands = start.channels / start.components;
        const std::size_t values = start.channels + (start.has_error ? bands : 0) + (start.has_depth ? 1 : 0);
        const off_t here = ftello(file_.get());
        struct stat status {};
        if (here < 0 || fstat(fileno(file_.get()), &status) != 0)
            throw Error("cannot read \"" + path_ + "\": " + std::strerror(errno), {}, Severity::system);
        if (status.st_size < here ||
            static_cast<std::size_t>(status.st_size - here) < pixels * values * sizeof(float))
            fail("it is cut short");
    }

    void read_frame(const Preamble& start, Frame& frame) {
        const std::size_t pixels = std::size_t(start.width) * start.height;
        std::vector<std::uint8_t> traced;
        read_values(traced, pixels);
        require_values(start, pixels - static_cast<std::size_t>(std::ranges::count(traced, 0)));
        frame.picture.width = start.width;
        frame.picture.height = start.height;
        frame.picture.channels = start.channels;
        frame.components = start.components;
        frame.picture.space = static_cast<ColorSpace>(start.space);
        frame.picture.pixels.resize(pixels * start.channels);
        if (start.has_depth) frame.depth.resize(pixels);
        const std::size_t bands = frame.bands();
        if (start.has_error) frame.error.resize(pixels * bands);
        for (std::size_t i = 0; i < pixels; ++i) {
            if (!traced[i]) continue;
            get(&frame.picture.pixels[i * start.channels], start.channels);
            if (start.has_depth) get(&frame.depth[i], 1);
            if (start.has_error) get(&frame.error[i * bands], bands);
        }
        frame.traced = std::move(traced);
    }

    const std::string& path_;
    std::string fingerprint_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

std::string partial_name(const std::string& output) { return output + ".partial"; }

void write_partial(std::FILE* file, const PartialFrame& partial, const std::vector<std::string>& lines) {
    std::fputs("#?RADIANCE\n", file);
    for (const std::string& line : lines) std::fprintf(file, "%s\n", line.c_str());
    if (!partial.fingerprint.empty())
        std::fprintf(file, "%s%s\n", std::string(fingerprint_key).c_str(), partial.fingerprint.c_str());
    std::fprintf(file, "VIEW=%s\n%s\n\n", format_view(partial.view).c_str(), format_line);
    std::fprintf(file, "-Y %d +X %d\n", partial.height, partial.width);

    const Frame& frame = partial.frame;
    const Picture& rows = partial.finished_rows;
    const Preamble start{.width = partial.width,
                         .height = partial.height,
                         .channels = frame.picture.channels,
                         .space = static_cast<int>(frame.picture.space),
                         .has_depth = frame.depth.empty() ? 0 : 1,
                         .has_error = frame.error.empty() ? 0 : 1,
                         .finished_rows = rows.height,
                         .finished_channels = rows.channels,
                         .finished_space = static_cast<int>(rows.space),
                         .components = frame.components};
    std::fwrite(&start, sizeof start, 1, file);
    put(file, numbers_of(partial.view));
    std::fwrite(&partial.pixel_aspect, sizeof partial.pixel_aspect, 1, file);
    put(file, rows.pixels);
    // Others may trace on meanwhile.
    std::vector<std::uint8_t> traced(frame.traced.size());
    for (std::size_t i = 0; i < traced.size(); ++i) traced[i] = frame.is_traced(i) ? 1 : 0;
    put(file, traced);
    const std::size_t channels = frame.picture.channels, bands = frame.bands();
    for (std::size_t i = 0; i < traced.size(); ++i) {
        if (!traced[i]) continue;
        std::fwrite(&frame.picture.pixels[i * channels], sizeof(float), channels, file);
        if (start.has_depth) std::fwrite(&frame.depth[i], sizeof(float), 1, file);
        if (start.has_error) std::fwrite(&frame.error[i * bands], sizeof(float), bands, file);
    }
    if (std::fflush(file) != 0 || std::ferror(file))
        throw Error(std::string("cannot keep the unfinished picture: ") + std::strerror(errno), {},
                    Severity::system);
}

void write_partial(const std::string& path, const PartialFrame& partial,
                   const std::vector<std::string>& lines) {
    AtomicFile file(path);
    write_partial(file.stream(), partial, lines);
    file.commit();
}

bool is_partial(const std::string& path) { return PartialReader(path).read_header(); }

std::string partial_fingerprint(const std::string& path) {
    PartialReader reader(path);
    return reader.read_header() ? reader.fingerprint() : std::string();
}

PartialFrame read_partial(const std::string& path, const Channels& channels) {
    return PartialReader(path).read(channels);
}

}  // namespace infra
