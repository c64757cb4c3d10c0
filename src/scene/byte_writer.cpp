#include "scene/byte_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>

#include "common/error.h"

namespace infra {
namespace {

Error output_error() { return Error("cannot write the output: is the device full?", "", Severity::system); }

}  // namespace

void ByteWriter::real(double value) {
    constexpr std::int64_t largest = 0x7fffffff;
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::frexp(value, &exponent) * double(largest));
    if (exponent > 127) {
        mantissa = mantissa > 0 ? largest : -largest;
        exponent = 127;
    } else if (exponent < -128) {
        mantissa = 0;
        exponent = 0;
    }
    integer(mantissa, 4);
    integer(exponent, 1);
}

void ByteWriter::string(std::string_view text) {
    this->text(text);
    byte(0);
}

void ByteWriter::text(std::string_view text) {
    while (!text.empty()) {
        const std::size_t size = std::min(text.size(), buffer_size);
        std::memcpy(place(size), text.data(), size);
        text.remove_prefix(size);
    }
}

void ByteWriter::integers(std::span<const std::int32_t> values) {
    for (const std::int32_t value : values) {
        const auto bits = static_cast<std::uint32_t>(value);
        char* const to = place(4);
        for (int i = 0; i < 4; ++i) to[i] = static_cast<char>(bits >> 8 * (3 - i));
    }
}

void ByteWriter::finish() {
    flush();
    out_.flush();
    if (!out_) throw output_error();
}

void ByteWriter::flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
    if (!out_) throw output_error();
}

}  // namespace infra
