#include "common/raypath.h"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdlib>

#include "common/error.h"

namespace infra {
namespace {

/// Folder of the running program, or "" where the system doesn't tell.
std::string program_directory() {
    std::array<char, PATH_MAX> buffer;
    const ssize_t length = readlink("/proc/self/exe", buffer.data(), buffer.size());
    if (length <= 0 || std::size_t(length) == buffer.size()) return {};
    const std::string_view path(buffer.data(), length);
    return std::string(path.substr(0, path.rfind('/')));
}

/// "~/x" and "~user/x" with the home folder put in; nothing for an unknown user.
std::optional<std::string> with_home(std::string_view name) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const std::string user(name.substr(1, slash - 1));
    const char* home = nullptr;
    if (user.empty()) {
        home = std::getenv("HOME");
    } else if (const passwd* entry = getpwnam(user.c_str())) {
        home = entry->pw_dir;
    }
    if (!home) return std::nullopt;
    return home + std::string(name.substr(slash));
}

bool readable(const std::string& path) { return access(path.c_str(), R_OK) == 0; }

}  // namespace

std::vector<std::string> library_directories() {
    std::vector<std::string> directories;
    const char* variable = std::getenv("RAYPATH");
    std::string_view rest = variable ? variable : "";
    for (;;) {
        const std::size_t colon = rest.find(':');
        directories.emplace_back(rest.substr(0, colon));
        if (colon == std::string_view::npos) break;
        rest.remove_prefix(colon + 1);
    }
    if (const std::string program = program_directory(); !program.empty()) {
        directories.push_back(program + "/../lib");
        directories.push_back(program + "/../share/infradiance");
    }
    return directories;
}

std::optional<std::string> find_library_file(std::string_view name) {
    if (name.empty()) return std::nullopt;
    if (name[0] == '~' || name[0] == '/' || name[0] == '.') {
        const auto path = name[0] == '~' ? with_home(name) : std::string(name);
        return path && readable(*path) ? path : std::nullopt;
    }
    for (std::string path : library_directories()) {
        if (!path.empty() && path.back() != '/') path += '/';
        path += name;
        if (readable(path)) return path;
    }
    return std::nullopt;
}

std::string require_library_file(std::string_view name, std::string_view kind) {
    if (auto path = find_library_file(name)) return *path;
    std::string message = "cannot find " + std::string(kind) + " \"" + std::string(name) + "\"";
    if (name.empty() || name[0] == '~' || name[0] == '/' || name[0] == '.') throw Error(message);
    std::string hint = "looked in";
    for (const std::string& directory : library_directories())
        hint += " " + (directory.empty() ? std::string("the current folder") : directory) + ",";
    hint.back() = ';';
    throw Error(message, hint + " set RAYPATH to look elsewhere");
}

}  // namespace infra
