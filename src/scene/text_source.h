// Characters of a scene file one after another, with the line they stand on.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/short_number.h"

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
    /// Takes blanks: white space as in ASCII.
    void skip_blanks() {
        for (;; ++next_) {
            if (next_ == end_ && !refill()) return;
            if (!is_blank(static_cast<unsigned char>(*next_))) return;
            line_ += *next_ == '\n';
        }
    }
    /// Takes the word that stands here if it ends within `longest` characters and they are plain: no quotes,
    /// no zero bytes. Otherwise takes nothing. It stays valid until the source is asked for more.
    ///   returns  "" where there is no such word
    std::string_view plain_word(std::size_t longest) {
        const char* last = plain_end(next_);
        if (last == end_) {
            more();
            last = plain_end(next_);
        }
        const auto size = static_cast<std::size_t>(last - next_);
        if (size > longest || (last < end_ && !is_blank(static_cast<unsigned char>(*last)))) return {};
        return {std::exchange(next_, last), size};
    }

    /// Takes the number that stands here, after blanks, if it is short, as most are: up to 7 digits and a
    /// point. Otherwise takes at most the blanks.
    bool short_number(double& value) {
        skip_blanks();
        const std::size_t size = parse_short_number({next_, static_cast<std::size_t>(end_ - next_)}, value);
        next_ += size;
        return size > 0;
    }

    /// Takes as many short numbers as stand here one after another, up to `count`.
    ///   returns  how many there were
    std::size_t short_numbers(double* values, std::size_t count) {
        std::size_t taken = 0;
        while (taken < count) {
            // A blank and a number are mostly all there is.
            const char* next = next_;
            for (; taken < count && next != end_ && *next == ' '; ++taken) {
                ++next;
                const std::size_t size =
                    parse_short_number({next, static_cast<std::size_t>(end_ - next)}, values[taken]);
                if (size == 0) break;
                next += size;
            }
            next_ = next;
            if (taken == count || !short_number(values[taken])) break;
            ++taken;
        }
        return taken;
    }

    /// Takes the digit that stands here, after blanks, if it is all of a word. Otherwise takes at most the
    /// blanks.
    bool lone_digit(int& value) {
        skip_blanks();
        if (end_ - next_ < 2 || *next_ < '0' || *next_ > '9') return false;
        if (!is_blank(static_cast<unsigned char>(next_[1]))) return false;
        value = *next_++ - '0';
        return true;
    }

    static constexpr bool is_blank(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    static constexpr bool is_quote(int c) { return c == '"' || c == '\''; }

    /// Line of the next character, from 1.
    int line() const { return line_; }
    const std::string& name() const { return name_; }

  private:
    bool refill();
    /// Reads on behind what is left.
    bool more();
    /// The end of the plain characters from here on, at most end_.
    const char* plain_end(const char* from) const;

    std::FILE* file_ = nullptr;
    std::vector<char> buffer_;
    const char* next_ = nullptr;
    const char* end_ = nullptr;
    int line_ = 1;
    std::string name_;
};

}  // namespace infra
