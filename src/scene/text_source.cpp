#include "scene/text_source.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace infra {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

constexpr auto is_plain = [] {
    std::array<bool, 256> plain{};
    for (int c = 1; c < 256; ++c) plain[c] = !TextSource::is_blank(c) && !TextSource::is_quote(c);
    return plain;
}();

}  // namespace

TextSource::TextSource(std::FILE* file, std::string name)
    : file_(file), buffer_(buffer_size), name_(std::move(name)) {}

TextSource::TextSource(std::string_view text, std::string name)
    : next_(text.data()), end_(text.data() + text.size()), name_(std::move(name)) {}

bool TextSource::refill() {
    next_ = end_;
    return more();
}

bool TextSource::more() {
    if (file_ == nullptr) return false;
    const auto left = static_cast<std::size_t>(end_ - next_);
    if (left == buffer_.size()) return false;
    if (left > 0) std::memmove(buffer_.data(), next_, left);
    const std::size_t count = std::fread(buffer_.data() + left, 1, buffer_.size() - left, file_);
    if (count == 0 && std::ferror(file_))
        throw Error(Location{name_}, std::string("cannot be read: ") + std::strerror(errno));
    next_ = buffer_.data();
    end_ = next_ + left + count;
    return count > 0;
}

const char* TextSource::plain_end(const char* from) const {
    while (from < end_ && is_plain[static_cast<unsigned char>(*from)]) ++from;
    return from;
}

}  // namespace infra
