#include "scene/text_source.h"

#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace infra {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

}  // namespace

TextSource::TextSource(std::FILE* file, std::string name)
    : file_(file), buffer_(buffer_size), name_(std::move(name)) {}

TextSource::TextSource(std::string_view text, std::string name)
    : next_(text.data()), end_(text.data() + text.size()), name_(std::move(name)) {}

bool TextSource::refill() {
    if (file_ == nullptr) return false;
    const std::size_t count = std::fread(buffer_.data(), 1, buffer_.size(), file_);
    if (count == 0 && std::ferror(file_))
        throw Error(Location{name_}, std::string("cannot be read: ") + std::strerror(errno));
    next_ = buffer_.data();
    end_ = next_ + count;
    return count > 0;
}

}  // namespace infra
