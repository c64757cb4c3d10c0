// Files that appear whole or not at all.
#pragma once

#include <cstdio>
#include <string>

namespace infra {

/// Writes to "<path>.part" and gives it its name on commit(). A file not committed is removed, also when the
/// program is ended by SIGINT or SIGTERM under an InterruptGuard.
class AtomicFile {
  public:
    /// throws Error when "<path>.part" cannot be made.
    explicit AtomicFile(std::string path);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// The open stream, for writing. Null after close() or commit().
    std::FILE* stream() const { return stream_; }
    /// Where the bytes go for now.
    const std::string& part_path() const { return part_; }

    /// Closes the stream and keeps the file, so that a library may open part_path() itself. throws Error when
    /// bytes were lost.
    void close();
    /// Closes and renames. throws Error when bytes were lost or the name cannot be given.
    void commit();

  private:
    std::string path_;
    std::string part_;
    std::FILE* stream_ = nullptr;
    bool committed_ = false;
};

}  // namespace infra
