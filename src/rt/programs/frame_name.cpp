#include "rt/programs/frame_name.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"

namespace infra {
namespace {

constexpr std::size_t longest_width = 3;  // digits

/// Length of the number's place at the start of the text, 0 if there is none.
std::size_t place_length(std::string_view text) {
    if (!text.starts_with('%')) return 0;
    const std::size_t digits = std::min(text.find_first_not_of(" +-", 1), text.size());
    const std::size_t letter = std::min(text.find_first_not_of("0123456789", digits), text.size());
    if (letter - digits > longest_width || letter == text.size()) return 0;
    return std::string_view("diuxXo").find(text[letter]) == std::string_view::npos ? 0 : letter + 1;
}

bool lock_file(int file) {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    return fcntl(file, F_SETLK, &whole) == 0;
}

}  // namespace

bool has_frame_number(const std::string& pattern) { return frame_name(pattern, 0) != frame_name(pattern, 1); }

std::string frame_name(const std::string& pattern, int number) {
    std::string name;
    for (std::string_view rest = pattern; !rest.empty();) {
        std::size_t taken = place_length(rest);
        if (taken > 0) {
            name += formatted(std::string(rest.substr(0, taken)).c_str(), number);
        } else {
            name += rest[0];
            taken = rest.starts_with("%%") ? 2 : 1;
        }
        rest.remove_prefix(taken);
    }
    return name;
}

FrameClaim::FrameClaim(const std::string& path) : path_(path) {
    constexpr mode_t readable_and_writable = 0666;
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, readable_and_writable);
    if (file < 0 && errno == EEXIST) return;
    if (file < 0)
        throw Error("cannot open output file \"" + path + "\": " + std::strerror(errno), {},
                    Severity::system);
    close(file);
    granted_ = true;
    remove_on_interrupt(path_.c_str());
}

bool FrameClaim::take_over() {
    if (granted_) return true;
    const int file = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return false;
    // Before it was locked, the picture may have taken its place.
    struct stat opened {
    }, named{};
    granted_ = lock_file(file) && fstat(file, &opened) == 0 && stat(path_.c_str(), &named) == 0 &&
               opened.st_ino == named.st_ino && opened.st_dev == named.st_dev && opened.st_size == 0;
    if (granted_) {
        file_ = file;
        remove_on_interrupt(path_.c_str());
    } else {
        close(file);
    }
    return granted_;
}

void FrameClaim::lock() {
    if (!granted_ || file_ >= 0) return;
    file_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ >= 0) lock_file(file_);
}

FrameClaim::~FrameClaim() {
    if (file_ >= 0) close(file_);
    if (!granted_) return;
    if (!kept_) unlink(path_.c_str());
    forget_on_interrupt(path_.c_str());
}

}  // namespace infra
