// Where function files, data files and octrees named in a scene are looked for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace infra {

/// The folders searched for library files: those of $RAYPATH (separated by ':', an empty one is the current
/// folder), then ../lib and ../share/infradiance beside the running program. Without $RAYPATH the current
/// folder comes first.
std::vector<std::string> library_directories();

/// Path of the first readable file called `name` in library_directories(), or nothing.
/// Names that start with '/', '.' or '~' (home folder, also "~user/") are not searched for but taken as they
/// are.
std::optional<std::string> find_library_file(std::string_view name);

/// As find_library_file, but throws Error naming the file, the kind of file it should have been ("function
/// file") and the folders that were searched.
std::string require_library_file(std::string_view name, std::string_view kind);

}  // namespace infra
