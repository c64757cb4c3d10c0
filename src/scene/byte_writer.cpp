#include "scene/byte_writer.h"

#include <cmath>
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
    buffer_ += text;
    byte(0);
}

void ByteWriter::finish() {
    flush();
    out_.flush();
    if (!out_) throw output_error();
}

void ByteWriter::flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
    if (!out_) throw output_error();
}

}  // namespace infra
