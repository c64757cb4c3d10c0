#include "common/text_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "common/error.h"

namespace infra {
namespace {

constexpr std::size_t largest_file = std::size_t(1) << 31;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw Error("cannot read \"" + path + "\": " + what);
}

std::string read_all(std::FILE* file, const std::string& path) {
    std::string text;
    char buffer[1 << 16];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file)) {
        if (text.size() + n > largest_file) fail(path, "larger than 2 GiB");
        text.append(buffer, n);
    }
    if (std::ferror(file)) fail(path, std::strerror(errno));
    return text;
}

}  // namespace

std::string read_text_file(const std::string& path) {
    if (path == "-") return read_all(stdin, "standard input");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail(path, std::strerror(errno));
    struct stat status {};
    if (fstat(fileno(file.get()), &status) == 0 && S_ISDIR(status.st_mode)) fail(path, "it is a folder");
    return read_all(file.get(), path);
}

}  // namespace infra
