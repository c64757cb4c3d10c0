#include "common/error.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <vector>

namespace infra {
namespace {

std::string complete_line(const Location& where, std::string_view message, std::string_view hint) {
    std::string line;
    if (!where.file.empty()) {
        line += where.file;
        if (where.line > 0) line += ":" + std::to_string(where.line);
        if (where.line > 0 && where.column > 0) line += ":" + std::to_string(where.column);
        line += ": ";
    }
    line += message;
    if (!hint.empty()) line.append(" (").append(hint).append(")");
    return line;
}

/// Whether a byte goes on with a character of UTF-8.
bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Bytes of the character of UTF-8 that `text` begins with; 0 for a control character and for none.
std::size_t printable_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80U) return first >= ' ' && first != 0x7FU;
    const std::size_t length = first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
    if (first < 0xC2U || first > 0xF4U || text.size() < length) return 0;
    unsigned code = first & (0x7FU >> length);
    for (const char byte : text.substr(1, length - 1)) {
        if (!is_continuation(byte)) return 0;
        code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    constexpr unsigned least[] = {0xA0, 0x800, 0x10000};  // below 0xA0 are further control characters
    const bool is_surrogate = code >= 0xD800U && code < 0xE000U;
    return code >= least[length - 2] && code < 0x110000U && !is_surrogate ? length : 0;
}

/// A full device shows only when the last bytes leave the buffer.
void flush_standard_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw Error("cannot write the standard output", "is the device full?", Severity::system);
}

}  // namespace

Error::Error(Location where, std::string_view message, std::string_view hint, Severity severity)
    : std::runtime_error(complete_line(where, message, hint)),
      where_(std::move(where)),
      message_(message),
      hint_(hint),
      severity_(severity) {}

Error::Error(std::string_view message, std::string_view hint, Severity severity)
    : Error(Location{}, message, hint, severity) {}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

std::string one_line(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t length = printable_length(text);
        line += length > 0 ? text.substr(0, length) : "?";
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return line;
}

std::string message_line(std::string_view text) {
    constexpr std::size_t longest_word = 300;
    const std::string line = one_line(text);
    std::string shortened;
    std::size_t characters = 0;
    for (const char c : line) {
        characters = c == ' ' ? 0 : characters + !is_continuation(c);
        if (characters <= longest_word) shortened += c;
        if (characters == longest_word + 1 && !is_continuation(c)) shortened += "...";
    }
    return shortened;
}

int report_exception(const char* program) {
    try {
        throw;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s\n", program, message_line(error.what()).c_str());
        return static_cast<int>(error.severity());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "%s: out of memory\n", program);
        return static_cast<int>(Severity::system);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: internal error: %s\n", program, message_line(error.what()).c_str());
        return static_cast<int>(Severity::internal);
    }
}

int run_program(const char* name, int (*body)(int argc, char** argv), int argc, char** argv) {
    try {
        const int status = body(argc, argv);
        flush_standard_output();
        return status;
    } catch (...) {
        return report_exception(name);
    }
}

}  // namespace infra
