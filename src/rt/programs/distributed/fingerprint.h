// A number for everything that a picture depends on: pictures begun by one command are not finished by
// another.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/views/view.h"
#include "rt/programs/program_setup.h"

namespace infra {

class Fingerprint {
  public:
    void add_text(std::string_view text);
    void add_view(const View& view);

    /// Adds what is in the files that these words name, as they are or through RAYPATH; words that name none
    /// are passed over. A word may hold several, as a command does.
    void add_files(std::vector<std::string> words);

    std::uint64_t value() const { return state_; }
    std::string text() const;  ///< in hexadecimal digits

  private:
    void add_number(std::uint64_t number);
    void add_file(const std::string& path);
    std::uint64_t state_ = 0;
};

/// Of program, options and files.
///   command  without the options that do not change a picture
///   words    of the command that may name files of input
Fingerprint fingerprint_of(const LoadedScene& loaded, const std::string& command,
                           const std::vector<std::string>& words);

}  // namespace infra
