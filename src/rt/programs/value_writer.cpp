#include "rt/programs/value_writer.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <span>

#include "common/pictures/rgbe.h"

namespace infra {
namespace {

template <class Number>
void append_raw(std::string& out, Number value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

const char* format_name(NumberFormat format, const OutputColor& color) {
    switch (format) {
        case NumberFormat::text:
            return "ascii";
        case NumberFormat::floats:
            return "float";
        case NumberFormat::doubles:
            return "double";
        case NumberFormat::color:
            return pixel_format(color);
    }
    return "unknown";
}

void append_real(NumberFormat format, double value, std::string& out) {
    if (format == NumberFormat::floats) {
        append_raw(out, static_cast<float>(value));
    } else if (format == NumberFormat::doubles) {
        append_raw(out, value);
    } else {
        char text[32];  // "%e", several times faster
        const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 6).ptr;
        out.append(text, end).push_back('\t');
    }
}

void ValueWriter::vector(const Vec3& value) {
    real(value.x);
    real(value.y);
    real(value.z);
}

void ValueWriter::channels(const Spectrum& value) {
    for (int c = 0; c < value.channels(); ++c) real(double(value[c]));
}

void ValueWriter::numbers(const ValueConverter::Numbers& numbers) {
    const auto values = std::span(numbers.values).first(static_cast<std::size_t>(numbers.count));
    if (format_ == NumberFormat::color) {
        std::array<std::uint8_t, Channels::most + 1> pixel;
        to_common_exponent(values, std::span(pixel).first(values.size() + 1));
        out_.append(reinterpret_cast<const char*>(pixel.data()), values.size() + 1);
        return;
    }
    for (const float value : values) real(double(value));
}

void ValueWriter::name(std::string_view value) { out_.append(value).push_back('\t'); }

void ValueWriter::end_of_ray() {
    if (format_ == NumberFormat::text) out_.push_back('\n');
}

}  // namespace infra
