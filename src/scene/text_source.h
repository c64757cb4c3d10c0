// Characters of a scene file one after another, with the line they stand on.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace infra {

class TextSource {
  public:
    static constexpr int end = -1;

    /// Reads from an open stream, which stays the caller's. `name` is for messages.
    TextSource(std::FILE* file, std::string name);
    /// Reads text in memory that outlives the source.
    TextSource(std::string_view text, std::string name);

    /// Next character without taking it, or `end`. throws Error when the stream cannot be read.
    int peek() { return next_ < end_ || refill() ? static_cast<unsigned char>(*next_) : end; }
    /// Takes the next character.
    int get() {
        const int c = peek();
        if (c == end) return end;
        ++next_;
        line_ += c == '\n';
        return c;
    }
    /// Line of the next character, from 1.
    int line() const { return line_; }
    const std::string& name() const { return name_; }

  private:
    bool refill();

    std::FILE* file_ = nullptr;
    std::vector<char> buffer_;
    const char* next_ = nullptr;
    const char* end_ = nullptr;
    int line_ = 1;
    std::string name_;
};

}  // namespace infra
