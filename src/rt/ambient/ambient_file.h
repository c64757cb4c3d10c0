// Files of cached irradiance (-af): values of earlier runs, and of programs that run at the same time.
//
// Format, RADIANCE's: lines of text that say with what parameters the values were computed, NCOMP= and
// WAVELENGTH_SPLITS= (common/pictures/spectral_header.h), "FORMAT=Radiance_ambval", an empty line, the number
// 561 in 2 bytes, then records of 63 bytes and one more than there are channels: level (1 byte), weight,
// point (3), codes of normal and axis (4 bytes each), radii (2), gradient (2), turn (2), walls (4 bytes),
// radiance with a common exponent. Integers have their highest byte first; other numbers take 5 bytes
// (scene/byte_writer.h). writers: rpict, rtrace; RADIANCE's rpict, rtrace, rad. readers: the same, RADIANCE's
// lookamb.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "common/spectra/channels.h"
#include "common/spectra/resampler.h"
#include "rt/ambient/irradiance_value.h"
#include "scene/warnings.h"

namespace infra {

class ByteReader;
class ByteWriter;

class AmbientFile {
  public:
    using Taker = std::function<void(const IrradianceValue& value)>;

    /// Opens a file, or makes one. Locks it (as RADIANCE does, with fcntl) while it reads or writes, so that
    /// programs can share it.
    ///   lines    for the header of a new file
    ///   channels of the values here; those of the file may differ, and warn() is told so
    ///   throws   Error if it is not a file of values or cannot be made
    AmbientFile(const std::string& path, const Channels& channels, const std::vector<std::string>& lines,
                const WarningSink& warn);
    AmbientFile(const AmbientFile&) = delete;
    AmbientFile& operator=(const AmbientFile&) = delete;
    /// Writes what is left, as far as it can be written.
    ~AmbientFile();

    /// Hands over the values that are in the file and have not been read yet. A record that a program which
    /// was killed has left unfinished at the end is warned of and cut off.
    ///   throws  Error for a record that makes no sense, or when the file cannot be read
    void read_new(const Taker& take);

    /// Keeps a value to be written. True when there are so many that it is time for exchange().
    bool append(const IrradianceValue& value);
    /// Reads what others have added meanwhile and writes the values kept.
    void exchange(const Taker& take);

  private:
    class Lock;

    void open_or_make(const std::vector<std::string>& lines);
    std::string new_header(const std::vector<std::string>& lines) const;
    void read_header();
    void read_records(const Taker& take);
    std::size_t record_bytes() const;
    void read_record(ByteReader& in, IrradianceValue& value) const;
    void write_record(ByteWriter& out, const IrradianceValue& value) const;
    void write_kept();
    [[noreturn]] void fail(const char* what) const;

    const std::string path_;
    const Channels channels_;
    const WarningSink warn_;
    Channels file_channels_;
    std::optional<Resampler> from_file_, to_file_;  // where the channels differ
    std::FILE* file_ = nullptr;
    bool read_only_ = false;
    std::int64_t known_end_ = 0;  // of what has been read or written here
    std::string kept_;            // records to be written
};

}  // namespace infra
