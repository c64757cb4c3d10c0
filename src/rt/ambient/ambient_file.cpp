#include "rt/ambient/ambient_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <sstream>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/pictures/picture.h"
#include "common/pictures/rgbe.h"
#include "common/pictures/spectral_header.h"
#include "scene/byte_reader.h"
#include "scene/byte_writer.h"
#include "scene/mesh/direction_code.h"

namespace infra {
namespace {

constexpr const char* format_name = "Radiance_ambval";
constexpr const char* kind = "ambient file";
constexpr int magic = 561;
constexpr std::size_t longest_line = 1 << 16;
constexpr std::size_t fixed_bytes = 64;  // of a record, the exponent among them
constexpr std::size_t kept_bytes = 8192;

/// What scenes and our arithmetic leave room for.
bool sensible(double x) { return std::fabs(x) < 1e10; }

bool makes_sense(const IrradianceValue& value) {
    bool good = value.weight > 0 && value.weight <= 1 && value.normal != Vec3(0) && value.axis != Vec3(0);
    for (int i = 0; i < 3; ++i) good = good && sensible(value.point[i]);
    for (int i = 0; i < 2; ++i)
        good = good && value.radius[i] > 0 && sensible(value.radius[i]) && sensible(value.gradient[i]) &&
               sensible(value.turn[i]);
    return good && value.radius[0] <= value.radius[1] * (1 + 1e-6) && value.radiance.finite();
}

}  // namespace

/// Keeps other programs away for as long as it lives.
class AmbientFile::Lock {
  public:
    Lock(const AmbientFile& file, short type) : file_(file) { apply(type); }
    Lock(const Lock&) = delete;
    ~Lock() {
        struct flock lock = {};
        lock.l_type = F_UNLCK;
        fcntl(fileno(file_.file_), F_SETLK, &lock);
    }

  private:
    void apply(short type) const {
        struct flock lock = {};
        lock.l_type = type;
        while (fcntl(fileno(file_.file_), F_SETLKW, &lock) != 0)
            if (errno != EINTR) file_.fail("cannot be locked");
    }
    const AmbientFile& file_;
};

AmbientFile::AmbientFile(const std::string& path, const Channels& channels,
                         const std::vector<std::string>& lines, const WarningSink& warn)
    : path_(path), channels_(channels), warn_(warn) {
    open_or_make(lines);
    if (file_channels_ == channels_) return;
    warn_(path_ + ": the values have " + file_channels_.description() + ", not " + channels_.description() +
          ", and are converted");
    const auto between = [](const Channels& from, const Channels& to) {
        return Resampler(to, static_cast<std::size_t>(from.count()), from.longest_nm(), from.shortest_nm());
    };
    from_file_ = between(file_channels_, channels_);
    to_file_ = between(channels_, file_channels_);
}

AmbientFile::~AmbientFile() {
    if (!file_) return;
    try {
        exchange([](const IrradianceValue&) {});
    } catch (const Error&) {  // whoever wanted to know has called exchange()
    }
    std::fclose(file_);
}

void AmbientFile::fail(const char* what) const {
    throw Error(Location{path_}, std::string(kind) + " " + what + ": " + std::strerror(errno), {},
                Severity::system);
}

// Several programs may start at once: whoever gets the lock of an empty file first writes its header.
void AmbientFile::open_or_make(const std::vector<std::string>& lines) {
    int descriptor = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    read_only_ = descriptor < 0 && (errno == EACCES || errno == EROFS);
    if (read_only_) descriptor = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail("cannot be opened");
    file_ = fdopen(descriptor, read_only_ ? "r" : "r+");
    if (!file_) fail("cannot be opened");
    try {
        const Lock lock(*this, read_only_ ? F_RDLCK : F_WRLCK);
        if (!read_only_ && lseek(descriptor, 0, SEEK_END) == 0) {
            kept_ = new_header(lines);
            write_kept();
            file_channels_ = channels_;
        } else {
            read_header();
        }
    } catch (...) {
        std::fclose(file_);
        throw;
    }
}

std::string AmbientFile::new_header(const std::vector<std::string>& lines) const {
    std::string text = "#?RADIANCE\n";
    for (const std::string& line : lines) text += line + "\n";
    text += wavelength_splits_line(channels_) + "\n";
    text += formatted("NCOMP=%d\nFORMAT=%s\n\n", channels_.count(), format_name);
    text += static_cast<char>(magic >> 8);
    text += static_cast<char>(magic & 0xff);
    return text;
}

void AmbientFile::read_header() {
    std::rewind(file_);
    ByteReader in(file_, path_, kind);
    PictureHeader header;
    std::string line = in.line(longest_line);
    known_end_ = static_cast<std::int64_t>(line.size()) + 1;
    if (!line.starts_with("#?")) in.fail("this is no ambient file");
    while (!(line = in.line(longest_line)).empty()) {
        known_end_ += static_cast<std::int64_t>(line.size()) + 1;
        header.add(line);
    }
    if (header.value("FORMAT") != format_name || in.integer(2) != magic) in.fail("this is no ambient file");
    known_end_ += 1 + 2;
    int count = 3;
    if (const auto text = header.value("NCOMP"))
        if (!parse_int(*text, count) || count < Channels::fewest || count > Channels::most)
            in.fail_damaged("NCOMP=" + *text);
    const std::optional<Channels> bands = channels_of(header, count);
    const bool colors = count == 3 && (!bands || bands->shows_colors());
    if (!colors && !bands) in.fail_damaged("the wavelengths are unknown");
    file_channels_ = colors ? Channels() : *bands;
}

// Reading
// -----------------------------------------------------------------------------------------------------

void AmbientFile::read_new(const Taker& take) {
    const Lock lock(*this, read_only_ ? F_RDLCK : F_WRLCK);
    read_records(take);
}

void AmbientFile::read_records(const Taker& take) {
    const std::int64_t end = lseek(fileno(file_), 0, SEEK_END);
    if (end < 0) fail("cannot be read");
    const auto record = static_cast<std::int64_t>(record_bytes());
    if (std::fseek(file_, known_end_, SEEK_SET) != 0) fail("cannot be read");
    ByteReader in(file_, path_, kind);
    IrradianceValue value(channels_.count());
    for (; end - known_end_ >= record; known_end_ += record) {
        read_record(in, value);
        take(value);
    }
    if (known_end_ == end || read_only_) return;
    warn_(formatted("%s: the last %d bytes are no whole value and are dropped", path_.c_str(),
                    static_cast<int>(end - known_end_)));
    if (ftruncate(fileno(file_), known_end_) != 0) fail("cannot be written");
}

std::size_t AmbientFile::record_bytes() const {
    return fixed_bytes + static_cast<std::size_t>(file_channels_.count());
}

void AmbientFile::read_record(ByteReader& in, IrradianceValue& value) const {
    const auto pair = [&](double(&to)[2]) {
        for (double& x : to) x = in.real();
    };
    value.level = in.byte();
    value.weight = in.real();
    for (int i = 0; i < 3; ++i) value.point[i] = in.real();
    value.normal = decode_direction(static_cast<std::uint32_t>(in.integer(4)));
    value.axis = decode_direction(static_cast<std::uint32_t>(in.integer(4)));
    pair(value.radius);
    pair(value.gradient);
    pair(value.turn);
    value.walls = static_cast<std::uint32_t>(in.integer(4));

    std::array<float, Channels::most> mantissa;
    const int count = file_channels_.count();
    for (int c = 0; c < count; ++c) mantissa[c] = static_cast<float>(in.byte()) + 0.5f;
    const float factor = rgbe_factor(static_cast<std::uint8_t>(in.byte()));
    if (from_file_) {
        std::array<double, Channels::most> bands;
        for (int c = 0; c < count; ++c) bands[c] = static_cast<double>(factor * mantissa[c]);
        value.radiance = (*from_file_)(std::span(bands).first(static_cast<std::size_t>(count)));
    } else {
        for (int c = 0; c < count; ++c) value.radiance.set(c, factor * mantissa[c]);
    }
    if (!makes_sense(value))
        throw Error(Location{path_},
                    formatted("damaged %s: the value at byte %lld makes no sense", kind,
                              static_cast<long long>(known_end_)),
                    "remove the file to start again");
}

// Writing
// -----------------------------------------------------------------------------------------------------

bool AmbientFile::append(const IrradianceValue& value) {
    if (read_only_) return false;
    std::ostringstream bytes;
    ByteWriter out(bytes);
    write_record(out, value);
    out.finish();
    kept_ += bytes.view();
    return kept_.size() >= kept_bytes;
}

void AmbientFile::write_record(ByteWriter& out, const IrradianceValue& value) const {
    const auto pair = [&](const double(&from)[2]) {
        for (const double x : from) out.real(x);
    };
    out.byte(value.level);
    out.real(value.weight);
    for (int i = 0; i < 3; ++i) out.real(value.point[i]);
    out.integer(encode_direction(value.normal), 4);
    out.integer(encode_direction(value.axis), 4);
    pair(value.radius);
    pair(value.gradient);
    pair(value.turn);
    out.integer(value.walls, 4);

    Spectrum radiance = value.radiance;
    if (to_file_) {
        std::array<double, Channels::most> bands;
        for (int c = 0; c < radiance.channels(); ++c) bands[c] = static_cast<double>(radiance[c]);
        radiance = (*to_file_)(std::span(bands).first(static_cast<std::size_t>(radiance.channels())));
    }
    std::array<float, Channels::most> floats;
    std::array<std::uint8_t, Channels::most + 1> pixel;
    const auto count = static_cast<std::size_t>(radiance.channels());
    for (std::size_t c = 0; c < count; ++c) floats[c] = radiance[static_cast<int>(c)];
    to_common_exponent(std::span(floats).first(count), std::span(pixel).first(count + 1));
    for (std::size_t c = 0; c <= count; ++c) out.byte(pixel[c]);
}

void AmbientFile::exchange(const Taker& take) {
    if (read_only_ || kept_.empty()) return;
    const Lock lock(*this, F_WRLCK);
    read_records(take);
    write_kept();
}

// All or nothing: what a full device has left of a record is cut off again.
void AmbientFile::write_kept() {
    const int descriptor = fileno(file_);
    for (std::size_t done = 0; done < kept_.size();) {
        const ssize_t count = pwrite(descriptor, kept_.data() + done, kept_.size() - done,
                                     known_end_ + static_cast<std::int64_t>(done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int reason = errno;
            kept_.clear();
            [[maybe_unused]] const int ignored = ftruncate(descriptor, known_end_);
            errno = reason;
            fail("cannot be written");
        }
        done += static_cast<std::size_t>(count);
    }
    known_end_ += static_cast<std::int64_t>(kept_.size());
    kept_.clear();
}

}  // namespace infra
