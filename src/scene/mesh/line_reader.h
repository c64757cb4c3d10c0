// Lines of text files of any size, without copying them.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"

namespace infra {

class LineReader {
  public:
    /// Reads from an open stream, which stays the caller's; `name` is for messages.
    LineReader(std::FILE* file, std::string name);

    /// Sets `line` to the next line without its end, valid until the next call; false at the end of the file.
    /// Lines end with "\n", "\r\n" or "\r"; a '\\' before the end joins the next one on, as a blank.
    ///   throws  Error for a file that cannot be read or a line beyond 16 MiB
    bool next(std::string_view& line);

    /// Number of the last line of next(), from 1.
    int number() const { return number_; }
    const std::string& name() const { return name_; }
    /// throws Error "name:number: message (hint)".
    [[noreturn]] void fail(std::string_view message, std::string_view hint = {}) const;

  private:
    bool take(std::string_view& line);
    bool refill();

    std::FILE* file_;
    std::string name_;
    int number_ = 0;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;  // unread bytes of the buffer
    bool at_end_ = false;
    std::string joined_;
};

/// The next word of `text`, which loses it; empty at its end.
std::string_view take_word(std::string_view& text);

/// The next word as a number. Returns false and leaves `text` where it was if it is none.
bool take_real(std::string_view& text, double& value);

}  // namespace infra
