#include "scene/xform/output.h"

#include <charconv>

#include "common/format.h"

namespace infra::xform {
namespace {

constexpr std::size_t most_held_back = 64 << 20;

/// Twelve digits, right-aligned, so that coordinates stand below one another.
void append_real(std::string& text, double value) {
    constexpr int digits = 12;
    constexpr std::size_t width = 18;
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
    const auto length = static_cast<std::size_t>(end - buffer);
    text.append(length < width ? width + 1 - length : 1, ' ').append(buffer, length);
}

/// Numbers that are triples of coordinates (mostly) go three to a line.
bool in_triples(const ParsedPrimitive& p) { return info(p.type).is_geometry() || p.reals.size() > 8; }

}  // namespace

void Output::text(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > most_held_back) finish();
}

void Output::reals(const ParsedPrimitive& p) {
    for (std::size_t i = 0; i < p.reals.size(); ++i) {
        if (i % 3 == 0 && in_triples(p)) buffer_ += '\n';
        append_real(buffer_, p.reals[i]);
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
