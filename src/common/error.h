// The one error type for what users give us. Libraries throw it; only a program's main prints it and exits.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace infra {

/// Place in a user's text. An empty file means "nowhere in particular"; line and column count from 1, 0 is
/// unknown.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Exit status of a program, as RADIANCE's severities.
enum class Severity { user = 1, system = 2, internal = 3 };

/// what() is the whole line after "program: ", that is "file:line:column: message (hint)" without the parts
/// not known.
class Error : public std::runtime_error {
  public:
    Error(Location where, std::string_view message, std::string_view hint = {},
          Severity severity = Severity::user);
    explicit Error(std::string_view message, std::string_view hint = {}, Severity severity = Severity::user);

    const Location& where() const { return where_; }
    const std::string& message() const { return message_; }
    const std::string& hint() const { return hint_; }
    Severity severity() const { return severity_; }

  private:
    Location where_;
    std::string message_;
    std::string hint_;
    Severity severity_;
};

/// The name in `known` nearest to `name` by edit distance, or "" when none is near enough to be a likely
/// slip. shape: Range is any range of things convertible to string_view.
std::size_t edit_distance(std::string_view a, std::string_view b);
template <class Range>
std::string nearest_name(std::string_view name, const Range& known) {
    std::string best;
    std::size_t best_distance = name.size() / 3 + 1;
    for (const auto& candidate : known) {
        const std::string_view view(candidate);
        const std::size_t distance = edit_distance(name, view);
        const bool is_alike = distance < std::max(name.size(), view.size());  // not another word as short
        if (is_alike && distance > 0 && distance <= best_distance &&
            (best.empty() || distance < best_distance)) {
            best = std::string(view);
            best_distance = distance;
        }
    }
    return best;
}

/// A text as one printable line: control characters, which names of files may hold, and bytes that are not
/// UTF-8 become '?'.
std::string one_line(std::string_view text);

/// one_line() as messages print it: words longer than 300 characters are cut, marked by "...".
std::string message_line(std::string_view text);

/// Within a catch clause: prints what was caught as one line "program: what" on stderr and returns the exit
/// status for it.
int report_exception(const char* program);

/// Runs a program's body: prints any exception as one line "program: what" on stderr and turns it into the
/// exit status. Bytes that the body has printed and the standard output has lost are an error too.
int run_program(const char* name, int (*body)(int argc, char** argv), int argc, char** argv);

}  // namespace infra
