#include "scene/byte_reader.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "common/error.h"

namespace infra {

ByteReader::ByteReader(std::FILE* file, std::string name, std::string kind)
    : file_(file), name_(std::move(name)), kind_(std::move(kind)), buffer_(1 << 16) {}

bool ByteReader::refill() {
    const std::size_t count = std::fread(buffer_.data(), 1, buffer_.size(), file_);
    next_ = buffer_.data();
    end_ = next_ + count;
    return count > 0;
}

void ByteReader::fail(const std::string& message) const { throw Error(Location{name_}, message); }
void ByteReader::fail_damaged(const std::string& what) const { fail("damaged " + kind_ + ": " + what); }
int ByteReader::fail_truncated() const {
    if (std::ferror(file_)) fail(std::string("cannot be read: ") + std::strerror(errno));
    fail("truncated " + kind_);
}

void ByteReader::bytes(void* to, std::size_t count) {
    for (auto* next = static_cast<char*>(to); count > 0;) {
        if (next_ == end_ && !refill()) fail_truncated();
        const std::size_t part = std::min(count, static_cast<std::size_t>(end_ - next_));
        std::memcpy(next, next_, part);
        next_ += part;
        next += part;
        count -= part;
    }
}

std::int64_t ByteReader::any_integer(int size) {
    std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::int8_t>(byte()));
    while (--size > 0) bits = bits << 8 | static_cast<std::uint64_t>(byte());
    return static_cast<std::int64_t>(bits);
}

double ByteReader::real() {
    const std::int64_t mantissa = integer(4);
    const int exponent = static_cast<int>(integer(1));
    if (mantissa == 0) return 0.0;
    // The writer cut the mantissa off towards zero: the middle of what it may have been is the best guess.
    const double middle = double(mantissa) + (mantissa < 0 ? -0.5 : 0.5);
    return std::ldexp(middle * (1.0 / 0x7fffffff), exponent);
}

std::string ByteReader::up_to(char last, std::size_t longest) {
    std::string text;
    for (int c = byte(); c != static_cast<unsigned char>(last); c = byte()) {
        if (text.size() == longest) fail("this is no " + kind_);
        text += static_cast<char>(c);
    }
    return text;
}

std::string ByteReader::string(std::size_t longest) { return up_to('\0', longest); }
std::string ByteReader::line(std::size_t longest) { return up_to('\n', longest); }

}  // namespace infra
