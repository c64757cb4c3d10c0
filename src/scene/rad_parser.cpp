#include "scene/rad_parser.h"

#include <algorithm>

#include "common/parse_number.h"

namespace infra {
namespace {

/// Counts beyond these are taken for slips. An octree file keeps string counts in two bytes.
constexpr int most_strings = 32767;
constexpr int most_reals = 1 << 24;

std::string quoted(std::string_view text) {
    constexpr std::size_t shown = 60;
    std::string result = "\"";
    for (const char c : text.substr(0, shown)) result += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    if (text.size() > shown) result += "...";
    return result + "\"";
}

}  // namespace

std::string ParsedPrimitive::description() const {
    return std::string(infra::name(type)) + " \"" + name + "\"";
}

void RadParser::fail(std::string_view message, std::string_view hint) const {
    throw Error({source_.name(), word_line_, 0}, message, hint);
}

RadParser::Item RadParser::next() {
    source_.skip_blanks();
    if (source_.peek() == TextSource::end) return Item::end;
    line_ = source_.line();
    if (source_.peek() == '#') {
        read_comment();
        return Item::comment;
    }
    if (source_.peek() == '!') {
        read_command();
        return Item::command;
    }
    read_primitive();
    return Item::primitive;
}

void RadParser::read_comment() {
    text_.clear();
    for (int c = source_.peek(); c != TextSource::end && c != '\n'; c = source_.peek())
        text_ += static_cast<char>(source_.get());
}

/// To the end of the line; a backslash before the line end continues it, and the shell takes both out.
void RadParser::read_command() {
    text_.clear();
    for (int c = source_.get(); c != TextSource::end; c = source_.get()) {
        if (c == '\r' && source_.peek() == '\n') continue;
        if (c == '\n' && text_.back() != '\\') break;
        text_ += static_cast<char>(c);
    }
}

bool RadParser::read_word(std::string_view& word) {
    source_.skip_blanks();
    word_line_ = source_.line();
    word = source_.plain_word(longest_word);
    return !word.empty() || read_quoted_word(word);
}

/// Blank-separated; quotes keep blanks and may open in the middle of a word, as in a shell.
bool RadParser::read_quoted_word(std::string_view& word) {
    quoted_word_.clear();
    int quote = 0;
    bool any = false;
    for (int c = source_.peek(); c != TextSource::end; c = source_.peek()) {
        if (quote == 0 && TextSource::is_blank(c)) break;
        source_.get();
        any = true;
        if (c == 0) fail("a zero byte: this is not a text file");
        if (c == quote) {
            quote = 0;
        } else if (quote == 0 && TextSource::is_quote(c)) {
            quote = c;
        } else {
            quoted_word_ += static_cast<char>(c);
            if (quoted_word_.size() > longest_word)
                fail("a word of more than " + std::to_string(longest_word) + " characters, " +
                         quoted(quoted_word_),
                     quote ? "is its quote closed?" : "");
        }
    }
    if (quote != 0) fail(std::string("the quote opened by ") + static_cast<char>(quote) + " is never closed");
    word = quoted_word_;
    return any;
}

void RadParser::missing_word(std::string_view what) {
    word_line_ = line_;
    fail("the file ends before the " + std::string(what));
}

std::string RadParser::previous() const {
    if (previous_name_.empty()) return "";
    return std::string(infra::name(previous_type_)) + " \"" + previous_name_ + "\"";
}

void RadParser::refuse_tab(std::string_view word, const char* what) const {
    if (word.data() != quoted_word_.data()) return;  // blanks end a word without quotes
    if (word.find('\t') != std::string_view::npos)
        fail(std::string("a tab in the ") + what + " " + quoted(word));
}

void RadParser::read_primitive() {
    ParsedPrimitive& p = primitive_;
    previous_type_ = p.type;
    previous_name_.swap(p.name);
    p.strings.clear();
    if (!read_word(word_)) missing_word("modifier");
    refuse_tab(word_, "modifier");
    if (p.modifier != word_) p.modifier = word_;
    if (!read_word(word_)) missing_word("type of a primitive whose modifier is " + quoted(p.modifier));
    const bool as_before = word_ == infra::name(p.type);
    const auto type = as_before ? p.type : find_primitive_type(word_);
    if (!type) {
        const std::string near = nearest_primitive_type(word_);
        std::string hint;
        if (!near.empty()) {
            hint = "did you mean " + near + "?";
        } else if (!previous_name_.empty()) {
            hint = "has " + previous() + " before it the right number of arguments?";
        }
        fail("unknown type " + quoted(word_), hint);
    }
    p.type = *type;
    if (!read_word(word_)) missing_word("identifier of a " + std::string(infra::name(p.type)));
    refuse_tab(word_, "identifier");
    p.name = word_;
    if (info(p.type).is_modifier() && (p.name == "void" || p.name == "inherit"))
        fail(quoted(p.name) + " cannot be the identifier of a modifier");
    if (p.type == PrimitiveType::alias) {
        if (!read_word(word_)) missing_word("target of " + p.description());
        p.strings.emplace_back(word_);
        p.reals.clear();
    } else {
        read_arguments();
    }
}

int RadParser::read_count(const char* sort) {
    int digit = 0;
    if (source_.lone_digit(digit)) {
        word_line_ = source_.line();
        return digit;
    }
    if (!read_word(word_))
        missing_word(std::string("number of ") + sort + " arguments of " + primitive_.description());
    int count = 0;
    if (!parse_int(word_, count))
        fail(quoted(word_) + " where the number of " + sort + " arguments of " + primitive_.description() +
             " should stand");
    if (count < 0)
        fail("a negative number of " + std::string(sort) + " arguments, " + std::string(word_) + ", for " +
             primitive_.description());
    return count;
}

void RadParser::read_arguments() {
    const auto check_limit = [&](int count, int limit, const char* sort) {
        if (count > limit)
            fail(std::to_string(count) + " " + sort + " arguments for " + primitive_.description() +
                 ", more than the limit of " + std::to_string(limit));
    };
    const auto argument = [&](int i, int count, const char* sort) {
        if (read_word(word_)) return;
        word_line_ = line_;
        fail("the file ends inside " + primitive_.description() + ": " + std::to_string(count) + " " + sort +
             " arguments announced, " + std::to_string(i) + " found");
    };
    const int string_count = read_count("string");
    check_limit(string_count, most_strings, "string");
    for (int i = 0; i < string_count; ++i) {
        argument(i, string_count, "string");
        primitive_.strings.emplace_back(word_);
    }
    if (const int count = read_count("integer"); count != 0)
        fail(std::to_string(count) + " integer arguments for " + primitive_.description(),
             "no type has any: the count before the real arguments is 0");
    const int real_count = read_count("real");
    check_limit(real_count, most_reals, "real");
    std::vector<double>& reals = primitive_.reals;
    for (int i = 0; i < real_count;) {
        constexpr int most_at_once = 1 << 12;  // memory is only taken for what is there
        const int behind = i + std::min(real_count - i, most_at_once);
        if (reals.size() < std::size_t(behind)) reals.resize(std::size_t(behind));
        i += int(source_.short_numbers(&reals[std::size_t(i)], std::size_t(behind - i)));
        if (i == behind) continue;
        argument(i, real_count, "real");
        if (!parse_real(word_, reals[std::size_t(i)]))
            fail(quoted(word_) + " is not a number (real argument " + std::to_string(i + 1) + " of " +
                 std::to_string(real_count) + " of " + primitive_.description() + ")");
        ++i;
    }
    reals.resize(std::size_t(real_count));
}

}  // namespace infra
