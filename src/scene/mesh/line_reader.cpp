#include "scene/mesh/line_reader.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "common/parse_number.h"
#include "common/text.h"

namespace infra {
namespace {

constexpr std::size_t block_size = 1 << 20;
constexpr std::size_t longest_line = 1 << 24;

}  // namespace

LineReader::LineReader(std::FILE* file, std::string name) : file_(file), name_(std::move(name)) {}

void LineReader::fail(std::string_view message, std::string_view hint) const {
    throw Error(Location{name_, number_}, message, hint);
}

/// Moves the unread bytes to the front and adds a block. A '\r' that no '\n' follows becomes one.
bool LineReader::refill() {
    if (at_end_) return false;
    if (end_ - begin_ > longest_line) {
        ++number_;
        fail("a line of more than 16 MiB", "is it text?");
    }
    std::copy(buffer_.begin() + std::ptrdiff_t(begin_), buffer_.begin() + std::ptrdiff_t(end_),
              buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
    if (buffer_.size() < end_ + block_size + 1) buffer_.resize(end_ + block_size + 1);
    char* const block = buffer_.data() + end_;
    std::size_t count = std::fread(block, 1, block_size, file_);
    if (std::ferror(file_))
        throw Error(Location{name_}, std::string("cannot be read: ") + std::strerror(errno));
    at_end_ = count < block_size;
    if (count > 0 && block[count - 1] == '\r')  // its '\n' may be the next block's first byte
        if (const int c = std::getc(file_); c != EOF) block[count++] = static_cast<char>(c);
    for (char* p = block; (p = static_cast<char*>(std::memchr(p, '\r', std::size_t(block + count - p)))); ++p)
        if (p + 1 == block + count || p[1] != '\n') *p = '\n';
    end_ += count;
    return count > 0;
}

/// A line as it stands in the file.
bool LineReader::take(std::string_view& line) {
    std::size_t searched = begin_;
    const char* end = nullptr;
    while (true) {
        const std::size_t unread = end_ - searched;
        if (unread > 0) end = static_cast<const char*>(std::memchr(buffer_.data() + searched, '\n', unread));
        if (end) break;
        searched = end_ - begin_;  // where this is once refill() has moved it
        if (!refill()) break;
    }
    if (!end && begin_ == end_) return false;
    const char* const begin = buffer_.data() + begin_;
    const char* const stop = end ? end : buffer_.data() + end_;
    line = {begin, std::size_t(stop - begin)};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    begin_ = std::size_t(stop - buffer_.data()) + (end ? 1 : 0);
    ++number_;
    return true;
}

bool LineReader::next(std::string_view& line) {
    if (!take(line)) return false;
    if (line.empty() || line.back() != '\\') return true;
    joined_.clear();
    bool more = true;
    while (more && !line.empty() && line.back() == '\\') {
        joined_.append(line, 0, line.size() - 1);
        joined_ += ' ';
        if (joined_.size() > longest_line) fail("a line of more than 16 MiB", "is it text?");
        line = {};
        more = take(line);
    }
    joined_ += line;
    line = joined_;
    return true;
}

std::string_view take_word(std::string_view& text) {
    std::size_t begin = 0;
    while (begin < text.size() && is_blank(text[begin])) ++begin;
    std::size_t end = begin;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

bool take_real(std::string_view& text, double& value) {
    std::string_view rest = text;
    return parse_real(take_word(rest), value) && (text = rest, true);
}

}  // namespace infra
