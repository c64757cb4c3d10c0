// Which reader a picture needs.
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>

#include "common/error.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

enum class Format { radiance, open_exr, other };

/// Tells by the first bytes; the file is at its start again.
Format format_of(std::FILE* file) {
    char bytes[4] = {};
    const std::string_view start(bytes, std::fread(bytes, 1, sizeof bytes, file));
    std::rewind(file);
    if (start.starts_with("#?")) return Format::radiance;
    return start == "\x76\x2f\x31\x01" ? Format::open_exr : Format::other;
}

FilePointer open(const std::string& path) {
    FilePointer file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw Error("cannot open picture \"" + path + "\": " + std::strerror(errno));
    struct stat status {};
    if (fstat(fileno(file.get()), &status) == 0 && S_ISDIR(status.st_mode))
        throw Error("cannot open picture \"" + path + "\": it is a folder");
    return file;
}

}  // namespace

bool is_float_picture(const std::string& path) { return format_of(open(path).get()) != Format::other; }

Picture read_float_picture(const std::string& path) {
    const FilePointer file = open(path);
    switch (format_of(file.get())) {
        case Format::radiance:
            return read_hdr(file.get(), path);
        case Format::open_exr:
            return read_exr(path);
        case Format::other:
            break;
    }
    throw Error(Location{path}, "cannot read picture: it is neither RADIANCE's nor OpenEXR");
}

}  // namespace infra
