#include "rt/programs/distributed/shared_input.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "rt/programs/distributed/agreement.h"

namespace infra {
namespace {

[[noreturn]] void fail(const char* what) {
    throw Error(std::string(what) + ": " + std::strerror(errno), {}, Severity::system);
}

Bytes read_all() {
    constexpr std::size_t portion = 1 << 20;
    Bytes bytes;
    std::size_t size = 0;
    do {
        bytes.resize(size + portion);
        size += std::fread(bytes.data() + size, 1, portion, stdin);
    } while (size == bytes.size());
    if (std::ferror(stdin)) fail("cannot read the standard input");
    bytes.resize(size);
    return bytes;
}

/// A file without a name holds them.
void make_standard_input(const Bytes& bytes) {
    const int file = memfd_create("standard input", 0);
    if (file < 0) fail("cannot keep the standard input");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno != EINTR) fail("cannot keep the standard input");
        if (written > 0) done += static_cast<std::size_t>(written);
    }
    if (lseek(file, 0, SEEK_SET) != 0 || dup2(file, STDIN_FILENO) < 0) fail("cannot keep the standard input");
    close(file);
    std::clearerr(stdin);
}

}  // namespace

Bytes share_standard_input(Team& team) {
    Bytes bytes;
    take_step(team, [&] {
        if (team.leads()) bytes = read_all();
        return 0;
    });
    team.broadcast(bytes);
    take_step(team, [&] {
        make_standard_input(bytes);
        return 0;
    });
    return bytes;
}

}  // namespace infra
