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
    std::string line(text);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    return line;
}

int run_program(const char* name, int (*body)(int argc, char** argv), int argc, char** argv) {
    try {
        const int status = body(argc, argv);
        flush_standard_output();
        return status;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s\n", name, one_line(error.what()).c_str());
        return static_cast<int>(error.severity());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "%s: out of memory\n", name);
        return static_cast<int>(Severity::system);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: internal error: %s\n", name, one_line(error.what()).c_str());
        return static_cast<int>(Severity::internal);
    }
}

}  // namespace infra
