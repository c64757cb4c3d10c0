// The counterpart of byte_reader.h.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

namespace infra {

class ByteWriter {
  public:
    explicit ByteWriter(std::ostream& out) : out_(out) {}

    void byte(int value) {
        buffer_ += static_cast<char>(value);
        if (buffer_.size() >= flush_size) flush();
    }
    /// The lower `size` bytes of a two's complement integer, the highest first.
    void integer(std::int64_t value, int size) {
        while (--size >= 0) byte(static_cast<int>(value >> 8 * size & 0xff));
    }
    /// Mantissa of 4 bytes, exponent of 1. Values beyond 2^127 become 2^127, those below 2^-128 zero.
    void real(double value);
    void string(std::string_view text);
    /// Text without a zero at its end.
    void text(std::string_view text) { buffer_ += text; }
    /// Hands everything to the stream. throws Error when it fails, as byte() may.
    void finish();

  private:
    void flush();

    static constexpr std::size_t flush_size = 1 << 16;
    std::ostream& out_;
    std::string buffer_;
};

}  // namespace infra
