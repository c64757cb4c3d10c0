// The counterpart of byte_reader.h.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace infra {

class ByteWriter {
  public:
    explicit ByteWriter(std::ostream& out) : out_(out), buffer_(buffer_size) {}

    void byte(int value) {
        if (used_ == buffer_.size()) flush();
        buffer_[used_++] = static_cast<char>(value);
    }
    /// The lower `size` bytes of a two's complement integer, the highest first.
    void integer(std::int64_t value, int size) {
        while (--size >= 0) byte(static_cast<int>(value >> 8 * size & 0xff));
    }
    /// Integers of 4 bytes.
    void integers(std::span<const std::int32_t> values);
    /// Mantissa of 4 bytes, exponent of 1. Values beyond 2^127 become 2^127, those below 2^-128 zero.
    void real(double value);
    void string(std::string_view text);
    /// Text without a zero at its end.
    void text(std::string_view text);
    /// Hands everything to the stream. throws Error when it fails, as byte() may.
    void finish();

  private:
    void flush();

    /// Room for `size` bytes, at most buffer_size.
    char* place(std::size_t size) {
        if (buffer_.size() - used_ < size) flush();
        return buffer_.data() + std::exchange(used_, used_ + size);
    }

    static constexpr std::size_t buffer_size = 1 << 16;
    std::ostream& out_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
};

}  // namespace infra
