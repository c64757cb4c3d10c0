// Whole files into memory.
#pragma once

#include <string>

namespace infra {

/// All bytes of a file; the path "-" is the standard input.
/// throws Error when it cannot be opened or read, is a folder, or is larger than 2 GiB.
std::string read_text_file(const std::string& path);

}  // namespace infra
