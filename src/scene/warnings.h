// Remarks on input that is odd but usable. Libraries report them here; a program decides whether they are
// printed.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace infra {

/// Called with each warning: one line without program name, "scene.rad:12: polygon "p": zero area".
using WarningSink = std::function<void(std::string_view)>;

/// Prints "program: warning - text" on the standard error.
WarningSink print_warnings(std::string program);

/// Says nothing (oconv -w).
WarningSink no_warnings();

}  // namespace infra
