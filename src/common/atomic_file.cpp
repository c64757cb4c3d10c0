#include "common/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "common/error.h"
#include "common/interrupt.h"

namespace infra {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why, Severity severity = Severity::user) {
    throw Error("cannot write \"" + path + "\": " + why, {}, severity);
}

/// The file a chain of links leads to, so that the link itself stays.
std::string followed(const std::string& path) {
    char* resolved = realpath(path.c_str(), nullptr);
    if (!resolved) return path;
    std::string target(resolved);
    std::free(resolved);
    return target;
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(followed(path)) {
    struct stat status {};
    const bool exists = stat(path_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path_, "it is a folder");
    // A device or pipe (/dev/null) takes the bytes as they come: there is no name to give.
    const bool is_device = exists && !S_ISREG(status.st_mode);
    part_ = is_device ? path_ : path_ + ".part";
    stream_ = std::fopen(part_.c_str(), "wb");
    if (!stream_) fail(path_, std::strerror(errno));
    if (!is_device) remove_on_interrupt(part_.c_str());
}

AtomicFile::~AtomicFile() {
    if (stream_) std::fclose(stream_);
    if (part_ == path_) return;
    if (!committed_) unlink(part_.c_str());
    forget_on_interrupt(part_.c_str());
}

void AtomicFile::close() {
    if (!stream_) return;
    const bool lost = std::ferror(stream_) != 0;
    const bool closed = std::fclose(stream_) == 0;
    stream_ = nullptr;
    if (lost || !closed) fail(path_, std::strerror(errno), Severity::system);
}

void AtomicFile::commit() {
    close();
    if (part_ != path_ && std::rename(part_.c_str(), path_.c_str()) != 0)
        fail(path_, std::strerror(errno), Severity::system);
    committed_ = true;
}

}  // namespace infra
