// Splits function definitions into tokens. Blanks and nested { comments } separate tokens and are dropped.
#pragma once

#include <string_view>

#include "common/error.h"

namespace infra::cal {

struct Token {
    enum class Kind { end, name, number, symbol };

    Kind kind = Kind::end;
    std::string_view text;  ///< as written; a symbol is one character
    double number = 0;
    Location where;

    bool is(char symbol) const { return kind == Kind::symbol && text.front() == symbol; }
};

class Lexer {
  public:
    /// `text` must outlive the lexer and its tokens; `start` is the place of its first character.
    Lexer(std::string_view text, const Location& start);

    /// The token about to be read.
    const Token& current() const { return token_; }

    /// Moves on to the next token. throws Error for an open comment or a malformed number.
    void advance();

    /// Error at the current token that says what was wanted and what stands there instead.
    Error expected(std::string_view what) const;

  private:
    void skip_blanks_and_comments();
    void skip_comment();
    void read_number();
    void step();
    char peek(std::size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }

    std::string_view text_;
    std::size_t position_ = 0;
    Location here_;
    Token token_;
};

/// Whether a character can stand in a name after its first one.
bool is_name_character(char c);

}  // namespace infra::cal
