// The program xform as a function.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace infra::xform {

/// Carries out a command line, program name first, and writes the scene text to `out`.
///   throws  Error for bad options, files and scene text
void run(const std::vector<std::string>& words, std::FILE* out);

}  // namespace infra::xform
