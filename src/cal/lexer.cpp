#include "cal/lexer.h"

#include <cstdlib>
#include <string>

#include "common/text.h"

namespace infra::cal {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

bool is_name_character(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '.' || c == '`'; }

Lexer::Lexer(std::string_view text, const Location& start) : text_(text), here_(start) {
    if (here_.line > 0 && here_.column == 0) here_.column = 1;
    advance();
}

void Lexer::step() {
    if (text_[position_] == '\n' && here_.line > 0) {
        ++here_.line;
        here_.column = 1;
    } else if (here_.column > 0) {
        ++here_.column;
    }
    ++position_;
}

void Lexer::skip_comment() {
    const Location opening = here_;
    int depth = 0;
    do {
        if (position_ == text_.size()) throw Error(opening, "comment is never closed", "'}' expected");
        if (peek() == '{') ++depth;
        if (peek() == '}') --depth;
        step();
    } while (depth > 0);
}

void Lexer::skip_blanks_and_comments() {
    while (position_ < text_.size()) {
        if (peek() == '{') {
            skip_comment();
        } else if (is_blank(peek())) {
            step();
        } else {
            return;
        }
    }
}

void Lexer::read_number() {
    const auto skip_digits = [this] {
        while (is_digit(peek())) step();
    };
    const std::size_t begin = position_;
    skip_digits();
    if (peek() == '.') {
        step();
        if (position_ == begin + 1 && !is_digit(peek())) throw Error(token_.where, "a lone '.' is no number");
        skip_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
        step();
        if (peek() == '+' || peek() == '-') step();
        if (!is_digit(peek())) throw Error(here_, "the exponent of a number is missing");
        skip_digits();
    }
    token_.kind = Token::Kind::number;
    token_.text = text_.substr(begin, position_ - begin);
    token_.number = std::strtod(std::string(token_.text).c_str(), nullptr);
}

void Lexer::advance() {
    skip_blanks_and_comments();
    token_ = Token{};
    token_.where = here_;
    if (position_ == text_.size()) return;
    const char first = peek();
    if (is_digit(first) || first == '.') {
        read_number();
        return;
    }
    const std::size_t begin = position_;
    if (is_letter(first) || first == '`') {
        token_.kind = Token::Kind::name;
        while (is_name_character(peek())) step();
    } else {
        token_.kind = Token::Kind::symbol;
        step();
    }
    token_.text = text_.substr(begin, position_ - begin);
}

Error Lexer::expected(std::string_view what) const {
    std::string message = "syntax error: ";
    message.append(what).append(" expected, but ");
    if (token_.kind == Token::Kind::end) {
        message += "the text ends";
    } else {
        message.append("'").append(token_.text).append("' found");
    }
    return Error(token_.where, message);
}

}  // namespace infra::cal
