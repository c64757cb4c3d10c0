#include "scene/command_pipe.h"

#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace infra {

CommandPipe::CommandPipe(const std::string& command) : stream_(popen(command.c_str(), "r")) {
    if (stream_ == nullptr)
        throw Error(Location{command_title("!" + command)},
                    std::string("cannot be run: ") + std::strerror(errno), "", Severity::system);
}

CommandPipe::~CommandPipe() {
    if (stream_ != nullptr) pclose(stream_);
}

bool CommandPipe::close() {
    const int status = pclose(stream_);
    stream_ = nullptr;
    return status == 0;
}

std::string command_title(const std::string& command) {
    std::string title = "\"";
    for (std::size_t i = 0; i < command.size(); ++i) {
        if (command[i] == '\\' && i + 1 < command.size() && command[i + 1] == '\n') continue;
        title += command[i] == '\n' ? ' ' : command[i];
    }
    return title + "\"";
}

}  // namespace infra
