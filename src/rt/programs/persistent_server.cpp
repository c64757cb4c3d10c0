#include "rt/programs/persistent_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

#include "common/error.h"
#include "common/format.h"
#include "common/text_file.h"

namespace infra {
namespace {

/// A server that nobody asks ends, as RADIANCE's.
constexpr int idle_seconds = 8 * 3600;
constexpr int commands_waiting = 64;
constexpr int status_of_a_killed_child = 3;
constexpr std::array<int, 3> ending_signals{SIGHUP, SIGINT, SIGTERM};
constexpr int stream_count = 3;

/// A stream that the command was started without must not become a socket or file of ours. It stays one that
/// nothing comes from and that cannot be written to.
void open_missing_streams() {
    for (int stream = 0; stream < stream_count; ++stream)
        while (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0 && errno == EINTR) continue;
}

[[noreturn]] void fail(const std::string& what) {
    throw Error(what + ": " + std::strerror(errno), {}, Severity::system);
}

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

  private:
    int number_;
};

/// A new folder for the socket, removed with it unless kept.
class SocketFolder {
  public:
    explicit SocketFolder(std::string name_pattern) : name_(std::move(name_pattern)) {
        if (!mkdtemp(name_.data())) fail("cannot make folder \"" + name_ + "\"");
    }
    SocketFolder(const SocketFolder&) = delete;
    SocketFolder& operator=(const SocketFolder&) = delete;
    ~SocketFolder() {
        if (kept_) return;
        unlink(socket_path().c_str());
        rmdir(name_.c_str());
    }
    std::string socket_path() const { return name_ + "/socket"; }
    void keep() { kept_ = true; }

  private:
    std::string name_;
    bool kept_ = false;
};

sockaddr_un address_of(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) throw Error("name of socket \"" + path + "\" is too long");
    std::strcpy(address.sun_path, path.c_str());
    return address;
}

/// Descriptors in the message that comes with one byte of data.
struct StreamMessage {
    char byte = 0;
    iovec data{&byte, 1};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * stream_count)> control{};
    msghdr header{};

    StreamMessage() {
        header.msg_iov = &data;
        header.msg_iovlen = 1;
        header.msg_control = control.data();
        header.msg_controllen = control.size();
    }
};

bool send_streams(int socket) {
    StreamMessage message;
    cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int) * stream_count);
    const int streams[stream_count] = {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
    std::memcpy(CMSG_DATA(part), streams, sizeof streams);
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) == 1;
}

bool receive_streams(int socket, int (&streams)[stream_count]) {
    StreamMessage message;
    if (recvmsg(socket, &message.header, 0) != 1) return false;
    const cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    if (!part || part->cmsg_type != SCM_RIGHTS || part->cmsg_len != CMSG_LEN(sizeof streams)) return false;
    std::memcpy(streams, CMSG_DATA(part), sizeof streams);
    return true;
}

// A signal handler has no argument of ours.
std::atomic<bool> asked_to_end{false};
void on_ending_signal(int) { asked_to_end = true; }

/// The server's own life, in a process of its own.
class Server {
  public:
    /// The listener is closed in children.
    Server(Descriptor& listener, std::string persist_path, std::string socket_path, bool keep_messages)
        : listener_(listener),
          persist_path_(std::move(persist_path)),
          socket_path_(std::move(socket_path)),
          keep_messages_(keep_messages) {}

    /// Returns in a child that has work to do.
    void run() {
        leave_streams();
        catch_signals();
        for (;;) {
            pollfd wanted{listener_.number(), POLLIN, 0};
            const timespec idle{idle_seconds, 0};
            const int ready = ppoll(&wanted, 1, &idle, &usual_mask_);
            if (asked_to_end || ready == 0) end();
            if (ready < 0) continue;  // a child has ended
            const int command = accept(listener_.number(), nullptr, nullptr);
            if (command < 0) continue;
            const pid_t child = fork();
            if (child == 0 && supervise(command)) return;
            close(command);
        }
    }

  private:
    /// Whoever waits for the end of the first command's output must not wait for the server.
    void leave_streams() const {
        const int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, STDIN_FILENO);
        dup2(nothing, STDOUT_FILENO);
        if (!keep_messages_) dup2(nothing, STDERR_FILENO);
        close_all(stream_count, listener_.number() - 1);
        close_all(listener_.number() + 1, std::numeric_limits<int>::max());
    }

    /// Likewise for the pipes and locks that the command has inherited.
    static void close_all(int first, int last) {
        constexpr long most_tried = 1 << 16;
        if (first > last || close_range(first, last, 0) == 0) return;
        const long limit = std::min(sysconf(_SC_OPEN_MAX), most_tried);  // the kernel is older than the call
        for (int number = first; number <= last && number < limit; ++number) close(number);
    }

    /// Signals that were ignored stay so.
    void catch_signals() {
        struct sigaction action {};
        action.sa_handler = on_ending_signal;
        sigemptyset(&action.sa_mask);
        sigset_t ending;
        sigemptyset(&ending);
        for (std::size_t i = 0; i < ending_signals.size(); ++i) {
            sigaction(ending_signals[i], nullptr, &usual_actions_[i]);
            if (usual_actions_[i].sa_handler == SIG_IGN) continue;
            sigaction(ending_signals[i], &action, nullptr);
            sigaddset(&ending, ending_signals[i]);
        }
        sigprocmask(SIG_BLOCK, &ending, &usual_mask_);  // but while it polls
        signal(SIGCHLD, SIG_IGN);                       // nobody waits for children
    }

    void restore_signals() const {
        for (std::size_t i = 0; i < ending_signals.size(); ++i)
            sigaction(ending_signals[i], &usual_actions_[i], nullptr);
        signal(SIGCHLD, SIG_DFL);
        sigprocmask(SIG_SETMASK, &usual_mask_, nullptr);
    }

    [[noreturn]] void end() const {
        unlink(socket_path_.c_str());
        rmdir(socket_path_.substr(0, socket_path_.rfind('/')).c_str());
        // Someone may have removed it and started anew.
        if (std::string text; read_if_there(persist_path_, text) && text.find(socket_path_) != text.npos)
            unlink(persist_path_.c_str());
        _exit(0);
    }

    static bool read_if_there(const std::string& path, std::string& text) {
        try {
            text = read_text_file(path);
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    /// In a child of the server: starts another that does the work, in which it returns true, sees that it
    /// ends when the command does, and tells the command its exit status.
    bool supervise(int command) {
        restore_signals();
        listener_.close();
        int streams[stream_count];
        int alive[2];
        if (!receive_streams(command, streams) || pipe(alive) != 0) _exit(1);
        const pid_t worker = fork();
        if (worker == 0) {
            close(command);
            close(alive[0]);           // the other end closes with this process
            signal(SIGTERM, SIG_DFL);  // its supervisor ends it so
            for (int i = 0; i < stream_count; ++i) {
                if (i != STDERR_FILENO || !keep_messages_) dup2(streams[i], i);
                close(streams[i]);
            }
            leave_libraries_at_exit();
            return true;
        }
        close(alive[1]);
        for (const int stream : streams) close(stream);
        pollfd watched[2] = {{alive[0], 0, 0}, {command, 0, 0}};
        while (poll(watched, 2, -1) < 0 && errno == EINTR) continue;
        if (!(watched[0].revents & POLLHUP)) kill(worker, SIGTERM);
        int status = 0;
        if (worker < 0 || waitpid(worker, &status, 0) < 0) _exit(1);
        const std::int32_t answer = WIFEXITED(status) ? WEXITSTATUS(status) : status_of_a_killed_child;
        send(command, &answer, sizeof answer, MSG_NOSIGNAL);
        _exit(0);
    }

    /// Threads that libraries had started are not in this process, and what ends them at exit could wait for
    /// them for ever. What is registered last runs first.
    static void leave_libraries_at_exit() {
        on_exit(
            [](int status, void*) {
                std::fflush(nullptr);
                _exit(status);
            },
            nullptr);
    }

    Descriptor& listener_;
    std::string persist_path_, socket_path_;
    bool keep_messages_;
    sigset_t usual_mask_{};
    std::array<struct sigaction, ending_signals.size()> usual_actions_{};
};

}  // namespace

PersistentServer::PersistentServer(std::string path, std::string program)
    : path_(std::move(path)), program_(std::move(program)) {
    open_missing_streams();
    lock();
    find_server();
}

PersistentServer::~PersistentServer() {
    if (file_ < 0) return;
    unlink(path_.c_str());
    close(file_);
}

/// Whoever has the lock decides whether there is a server.
void PersistentServer::lock() {
    for (;;) {
        constexpr mode_t mode = 0644;
        file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, mode);
        if (file_ < 0) fail("cannot open persist file \"" + path_ + "\"");
        struct flock whole {};
        whole.l_type = F_WRLCK;
        whole.l_whence = SEEK_SET;
        while (fcntl(file_, F_SETLKW, &whole) < 0)
            if (errno != EINTR) fail("cannot lock persist file \"" + path_ + "\"");
        // It may have been removed while we waited.
        struct stat locked {
        }, named{};
        if (fstat(file_, &locked) == 0 && stat(path_.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
            locked.st_dev == named.st_dev)
            return;
        close(file_);
    }
}

void PersistentServer::find_server() {
    char buffer[2048];
    const ssize_t size = pread(file_, buffer, sizeof buffer, 0);
    const std::string text(buffer, size > 0 ? static_cast<std::size_t>(size) : 0);
    const std::vector<std::string> words = split_words(text);
    if (words.empty()) return;  // nobody's yet
    const auto let_go = [this] {
        close(file_);
        file_ = -1;
    };
    if (words.size() != 3 || std::atol(words[1].c_str()) <= 0) {
        let_go();
        throw Error(Location{path_}, "format error in persist file");
    }
    if (words[0] != program_) {
        let_go();
        throw Error("persist file for " + words[0] + ", not " + program_);
    }
    // After a crash the file is there, but nobody answers.
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    const sockaddr_un address = address_of(words[2]);
    if (connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        if (ftruncate(file_, 0) != 0) fail("cannot write persist file \"" + path_ + "\"");
        return;
    }
    socket_path_ = words[2];
    let_go();
}

std::optional<int> PersistentServer::use() {
    if (socket_path_.empty()) return std::nullopt;
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    const sockaddr_un address = address_of(socket_path_);
    if (connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        !send_streams(socket.number()))
        fail("cannot reach the process of persist file \"" + path_ + "\"");
    std::int32_t status = 0;
    if (recv(socket.number(), &status, sizeof status, MSG_WAITALL) != sizeof status)
        throw Error("the process of persist file \"" + path_ + "\" has ended", {}, Severity::system);
    return status;
}

void PersistentServer::leave_behind(bool keep_messages) {
    const char* const folder = std::getenv("TMPDIR");
    SocketFolder home(std::string(folder && *folder ? folder : "/tmp") + "/" + program_ + "-XXXXXX");
    const std::string socket_path = home.socket_path();
    Descriptor listener(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const sockaddr_un address = address_of(socket_path);
    if (listener.number() < 0 ||
        bind(listener.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(listener.number(), commands_waiting) != 0)
        fail("cannot make socket \"" + socket_path + "\"");

    std::fflush(nullptr);
    const pid_t server = fork();
    if (server < 0) fail("cannot start a persistent process");
    if (server == 0) {
        home.keep();   // the server removes it
        close(file_);  // the lock is the other process's
        file_ = -1;
        Server(listener, path_, socket_path, keep_messages).run();
        return;
    }
    const std::string text = program_ + " " + std::to_string(server) + "\n" + socket_path + "\n";
    if (pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
        const int reason = errno;
        kill(server, SIGKILL);  // nobody has seen it yet
        waitpid(server, nullptr, 0);
        errno = reason;
        fail("cannot write persist file \"" + path_ + "\"");
    }
    home.keep();
    close(file_);
    file_ = -1;
}

}  // namespace infra
