// Big-endian binary as RADIANCE's portable files have it: integers of any size, 5-byte floats, zero-ended
// strings.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace infra {

class ByteReader {
  public:
    /// Reads from an open stream, which stays the caller's. `name` and `kind` ("octree") are for messages.
    ByteReader(std::FILE* file, std::string name, std::string kind);

    /// Next byte, 0..255. throws Error "truncated octree" at the end, as all below.
    int byte() { return next_ < end_ || refill() ? static_cast<unsigned char>(*next_++) : fail_truncated(); }
    /// The next `count` bytes.
    void bytes(void* to, std::size_t count);
    /// Signed integer of `size` bytes, 1 to 8.
    std::int64_t integer(int size) {
        constexpr int usual = 4;
        return size == usual && end_ - next_ >= usual ? usual_integer() : any_integer(size);
    }
    /// As many integers of `size` bytes.
    void integers(std::vector<std::int64_t>& values, std::size_t count, int size) {
        constexpr int usual = 4;
        values.resize(count);
        if (size == usual && end_ - next_ >= usual * std::ptrdiff_t(count)) {
            for (std::int64_t& value : values) value = usual_integer();
        } else {
            for (std::int64_t& value : values) value = integer(size);
        }
    }
    /// 4 bytes of mantissa and 1 of exponent: 31 bits of precision.
    double real();
    /// Up to a zero byte. throws Error when longer than `longest`.
    std::string string(std::size_t longest);
    /// A line of text, without its end.
    std::string line(std::size_t longest);

    const std::string& name() const { return name_; }

    /// throws Error "name: damaged octree: what".
    [[noreturn]] void fail_damaged(const std::string& what) const;
    /// throws Error "name: message".
    [[noreturn]] void fail(const std::string& message) const;

  private:
    bool refill();
    /// Of 4 bytes, which must be there.
    std::int32_t usual_integer() {
        static_assert(std::endian::native == std::endian::little);
        std::uint32_t bits;
        std::memcpy(&bits, next_, sizeof bits);
        next_ += sizeof bits;
        return static_cast<std::int32_t>(__builtin_bswap32(bits));
    }
    std::int64_t any_integer(int size);
    [[noreturn]] int fail_truncated() const;
    std::string up_to(char last, std::size_t longest);

    std::FILE* file_;
    std::string name_;
    std::string kind_;
    std::vector<char> buffer_;
    const char* next_ = nullptr;
    const char* end_ = nullptr;
};

}  // namespace infra
