// Runs our programs as a user would: a command line in a folder of its own.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "../common/test_files.h"

namespace infra::test {

/// A temporary folder whose files are written and read by name.
class Folder {
  public:
    std::string path(const std::string& name) const { return folder_ / name; }
    bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    std::string read(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }

  private:
    TemporaryFolder folder_;
};

struct Outcome {
    int status = -1;  ///< exit status, or 128 + signal
    std::string out;
    std::string err;
};

/// Runs a shell command in the folder with our programs first on PATH. No setting of the tester's reaches
/// them.
inline Outcome run(const Folder& folder, const std::string& command) {
    const std::string script = "cd '" + folder.path("") +
                               "' && unset RAYPATH RENDER_OPTIONS; PATH='" INFRA_BIN_DIR "':$PATH; { " +
                               command + "\n} > .out 2> .err";
    const int raw = std::system(script.c_str());
    const int status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    return {status, folder.read(".out"), folder.read(".err")};
}

}  // namespace infra::test
