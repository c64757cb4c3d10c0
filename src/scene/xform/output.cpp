#include "scene/xform/output.h"

#include <charconv>

#include "common/format.h"

namespace infra::xform {
namespace {

constexpr std::size_t most_held_back = 64 << 20;

struct NumberStyle {
    int digits;
    std::size_t width;  ///< right-aligned, so that coordinates stand below one another
};
constexpr NumberStyle usual{12, 18};
constexpr NumberStyle short_numbers{6, 12};  // of the materials whose numbers a scale changes

void append_real(std::string& text, double value, const NumberStyle& style) {
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, style.digits).ptr;
    const auto length = static_cast<std::size_t>(end - buffer);
    if (length < style.width) text.append(style.width - length, ' ');
    text.append(buffer, length);
}

/// How RADIANCE's xform lays out the real arguments of a type behind their number.
struct Layout {
    NumberStyle style = usual;
    std::string_view row_begin;  ///< before the first number of each row but the one of the count
    std::size_t first_row = ~std::size_t(0);  ///< numbers in the row of the count
    std::size_t row = ~std::size_t(0);        ///< in later rows
};

Layout layout(PrimitiveType type) {
    switch (type) {
        case PrimitiveType::polygon:
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring:
        case PrimitiveType::brighttext:
        case PrimitiveType::colortext:
        case PrimitiveType::mixtext:
            return {usual, " ", 0, 3};
        case PrimitiveType::spotlight:
            return {usual, "\t", 4};
        case PrimitiveType::interface:
            return {short_numbers, "", 0, 4};
        case PrimitiveType::dielectric:
        case PrimitiveType::mist:
            return {short_numbers};
        default:
            return {};
    }
}

}  // namespace

void Output::text(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > most_held_back) finish();
}

void Output::reals(const ParsedPrimitive& p) {
    const Layout rows = layout(p.type);
    std::size_t left = rows.first_row;  // in this row
    std::string_view separator = " ";
    for (const double value : p.reals) {
        if (left == 0) {
            buffer_ += '\n';
            separator = rows.row_begin;
            left = rows.row;
        }
        buffer_ += separator;
        append_real(buffer_, value, rows.style);
        separator = " ";
        --left;
    }
    buffer_ += '\n';
}

void Output::primitive(const ParsedPrimitive& p) {
    buffer_ += '\n' + join_command({p.modifier, std::string(info(p.type).name), p.name}) + '\n';
    if (p.type == PrimitiveType::alias) return text("\t" + join_command(p.strings) + '\n');
    buffer_ += std::to_string(p.strings.size());
    if (!p.strings.empty()) buffer_ += ' ' + join_command(p.strings);
    buffer_ += "\n0\n" + std::to_string(p.reals.size());
    reals(p);
    text("");
}

void Output::finish() {
    std::fwrite(buffer_.data(), 1, buffer_.size(), file_);
    buffer_.clear();
    if (std::fflush(file_) != 0 || std::ferror(file_))
        throw Error("cannot write the output", "is the device full?", Severity::system);
}

}  // namespace infra::xform
