// -P and -PP: the first command with a persist file leaves a server with the loaded scene behind; later ones
// with the same file have their work done by children of it, which share its memory.
//
// The file's first line is the program and the server's process id, as RADIANCE has it, so that
// "kill $(awk '{print $2; exit}' file)" and rad end it. Unlike RADIANCE's, one server has any number of
// children at work at once, and they take over the streams of the command itself: nothing is copied through
// pipes.
#pragma once

#include <optional>
#include <string>

namespace infra {

class PersistentServer {
  public:
    /// Opens or makes the persist file, and waits while another command loads a scene for it.
    ///   program  other programs may not use the same file
    ///   throws   Error when the file cannot be made, is no persist file or another program's
    PersistentServer(std::string path, std::string program);
    PersistentServer(const PersistentServer&) = delete;
    PersistentServer& operator=(const PersistentServer&) = delete;
    /// Removes the file, if it is this command's and no server was left.
    ~PersistentServer();

    /// If there is a server, has this command's work done there, on the standard streams of this process, and
    /// returns its exit status.
    std::optional<int> use();

    /// Leaves a server behind. Call it when the scene is loaded and before any thread starts, any of the
    /// standard input is read or any output written. Returns in this process, which does its own work, and
    /// later in each child that the server makes for another command, which has that one's standard streams.
    ///   keep_messages  messages go to a file (-e): children keep it for their standard error
    ///   throws         Error when there can be no server
    void leave_behind(bool keep_messages);

  private:
    void lock();
    void find_server();

    std::string path_;
    std::string program_;
    std::string socket_path_;  ///< of the server there is, or ""
    int file_ = -1;            ///< open and locked by this process, or -1
};

}  // namespace infra
