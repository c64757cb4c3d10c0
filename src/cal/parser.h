// Recursive-descent parser of RADIANCE's expression language.
//
//     sum     = product { (+|-) product }
//     product = power { (*|/) power }
//     power   = signed [ ^ power ]                 so 2^3^2 is 2^(3^2), and
//     signed  = [+|-] factor                       -2^2 is (-2)^2
//     factor  = ( sum ) | number | $number | name | name ( sum {, sum} )
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cal/lexer.h"
#include "cal/symbols.h"
#include "cal/syntax.h"

namespace infra::cal {

/// Works out an expression that depends on constants alone. throws Error if it is outside its domain.
using ConstantEvaluator = std::function<double(const Node&)>;

struct Statement {
    std::optional<int> output_channel;  ///< of `$n = body`
    SymbolId symbol = 0;                ///< otherwise, what is defined
    Definition definition;
};

class Parser {
  public:
    /// Names are resolved in `context` (a path) as they are read. Without `evaluate`, constants are not
    /// folded.
    Parser(std::string_view text, const Location& start, std::string context, SymbolTable& symbols,
           ConstantEvaluator evaluate);

    /// The whole text as one expression.
    NodePtr expression();

    /// The next statement, or nothing at the end of the text.
    std::optional<Statement> statement(bool allow_output_channels);

  private:
    NodePtr sum();
    NodePtr product();
    NodePtr power();
    NodePtr signed_factor();
    NodePtr factor();
    NodePtr name_or_call();
    NodePtr multiplied(NodePtr left, NodePtr right);
    NodePtr divided(NodePtr left, NodePtr right, const Location& where);
    NodePtr raised(NodePtr base, NodePtr exponent, const Location& where);
    NodePtr folded(NodePtr node, const Location& where);
    bool is_constant(const Node& node) const;
    bool is_constant_function(const Node& node) const;
    void read_parameters(Definition& definition);
    void expect(char symbol);
    std::uint32_t channel_number();

    Lexer lexer_;
    std::string context_;
    SymbolTable& symbols_;
    ConstantEvaluator evaluate_;
    const Definition* function_ = nullptr;  ///< whose body is being read
    int nesting_ = 0;
};

}  // namespace infra::cal
