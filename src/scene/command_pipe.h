// Output of a shell command as a stream.
#pragma once

#include <cstdio>
#include <string>

namespace infra {

class CommandPipe {
  public:
    /// Runs `command` by /bin/sh. throws Error when that cannot be started.
    explicit CommandPipe(const std::string& command);
    CommandPipe(const CommandPipe&) = delete;
    CommandPipe& operator=(const CommandPipe&) = delete;
    ~CommandPipe();

    std::FILE* stream() const { return stream_; }
    /// Waits for the command; true if it ended with status 0.
    bool close();

  private:
    std::FILE* stream_;
};

/// "!command" as error messages show it, in quotes and on one line.
std::string command_title(const std::string& command);

}  // namespace infra
