#include "cal/parser.h"

#include <algorithm>

namespace infra::cal {
namespace {

constexpr int max_nesting =
    1000;  ///< of parentheses: keeps the parser's own recursion within any thread's stack
constexpr int max_depth = 2000;  ///< of a tree: the same for whoever walks it

using Kind = Node::Kind;

}  // namespace

Parser::Parser(std::string_view text, const Location& start, std::string context, SymbolTable& symbols,
               ConstantEvaluator evaluate)
    : lexer_(text, start), context_(std::move(context)), symbols_(symbols), evaluate_(std::move(evaluate)) {}

void Parser::expect(char symbol) {
    if (!lexer_.current().is(symbol)) throw lexer_.expected(std::string("'") + symbol + "'");
    lexer_.advance();
}

NodePtr Parser::expression() {
    NodePtr body = sum();
    if (lexer_.current().kind != Token::Kind::end) throw lexer_.expected("an operator or the end");
    return body;
}

std::optional<Statement> Parser::statement(bool allow_output_channels) {
    while (lexer_.current().is(';')) lexer_.advance();
    const Token first = lexer_.current();
    if (first.kind == Token::Kind::end) return {};
    Statement statement;
    Definition& definition = statement.definition;
    if (allow_output_channels && first.is('$')) {
        statement.output_channel = static_cast<int>(channel_number());
        expect('=');
        definition.body = sum();
    } else {
        if (first.kind != Token::Kind::name) throw lexer_.expected("the name of a variable or function");
        lexer_.advance();
        if (lexer_.current().is('(')) read_parameters(definition);
        definition.is_constant = lexer_.current().is(':');
        if (!definition.is_constant && !lexer_.current().is('=')) throw lexer_.expected("'=' or ':'");
        lexer_.advance();
        function_ = definition.is_function ? &definition : nullptr;
        definition.body = sum();
        function_ = nullptr;
        statement.symbol = symbols_.declare(first.text, context_);
    }
    if (lexer_.current().kind != Token::Kind::end) expect(';');
    return statement;
}

void Parser::read_parameters(Definition& definition) {
    definition.is_function = true;
    do {
        lexer_.advance();
        const Token& token = lexer_.current();
        if (token.kind != Token::Kind::name || token.text.find('`') != std::string_view::npos)
            throw lexer_.expected("the name of a parameter");
        definition.parameters.emplace_back(token.text);
        lexer_.advance();
    } while (lexer_.current().is(','));
    expect(')');
}

NodePtr Parser::sum() {
    if (++nesting_ > max_nesting) throw Error(lexer_.current().where, "expression is nested too deeply");
    NodePtr left = product();
    while (lexer_.current().is('+') || lexer_.current().is('-')) {
        const Location where = lexer_.current().where;
        const Kind kind = lexer_.current().is('+') ? Kind::add : Kind::subtract;
        lexer_.advance();
        NodePtr right = product();
        const bool constant = left->is_number() && right->is_number();
        left = make_parent(kind, std::move(left), std::move(right));
        if (constant) left = folded(std::move(left), where);
        if (left->depth > max_depth)
            throw Error(where, "expression is too long", "give parts of it names of their own");
    }
    --nesting_;
    return left;
}

NodePtr Parser::product() {
    NodePtr left = power();
    while (lexer_.current().is('*') || lexer_.current().is('/')) {
        const Location where = lexer_.current().where;
        const bool division = lexer_.current().is('/');
        lexer_.advance();
        NodePtr right = power();
        left = division ? divided(std::move(left), std::move(right), where)
                        : multiplied(std::move(left), std::move(right));
        if (left->depth > max_depth)
            throw Error(where, "expression is too long", "give parts of it names of their own");
    }
    return left;
}

// RADIANCE drops the other factor of a constant zero unseen, so that it may even be undefined.
NodePtr Parser::multiplied(NodePtr left, NodePtr right) {
    if (evaluate_) {
        if (left->is_number() && right->is_number()) return make_number(left->number * right->number);
        if (left->is_number(0) || right->is_number(0)) return make_number(0);
    }
    return make_parent(Kind::multiply, std::move(left), std::move(right));
}

NodePtr Parser::divided(NodePtr left, NodePtr right, const Location& where) {
    if (evaluate_) {
        if (right->is_number(0)) throw Error(where, "division by the constant zero");
        if (left->is_number() && right->is_number()) return make_number(left->number / right->number);
        if (left->is_number(0)) return make_number(0);
    }
    return make_parent(Kind::divide, std::move(left), std::move(right));
}

NodePtr Parser::power() {
    NodePtr base = signed_factor();
    if (!lexer_.current().is('^')) return base;
    const Location where = lexer_.current().where;
    lexer_.advance();
    if (++nesting_ > max_nesting) throw Error(where, "expression is nested too deeply");
    NodePtr exponent = power();
    --nesting_;
    return raised(std::move(base), std::move(exponent), where);
}

NodePtr Parser::raised(NodePtr base, NodePtr exponent, const Location& where) {
    const bool constant = base->is_number() && exponent->is_number();
    if (evaluate_ && !constant) {
        if (base->is_number(0)) return make_number(0);
        if (base->is_number(1) || exponent->is_number(0)) return make_number(1);
        if (exponent->is_number(1)) return base;
    }
    NodePtr node = make_parent(Kind::power, std::move(base), std::move(exponent));
    return constant ? folded(std::move(node), where) : std::move(node);
}

NodePtr Parser::signed_factor() {
    const bool minus = lexer_.current().is('-');
    if (minus || lexer_.current().is('+')) lexer_.advance();
    NodePtr operand = factor();
    if (!minus) return operand;
    if (operand->is_number()) return make_number(-operand->number);
    return make_parent(Kind::negate, std::move(operand));
}

NodePtr Parser::factor() {
    const Token token = lexer_.current();
    if (token.is('(')) {
        lexer_.advance();
        NodePtr inner = sum();
        expect(')');
        return inner;
    }
    if (token.is('$')) return make_leaf(Kind::channel, channel_number(), token.where);
    if (token.kind == Token::Kind::name) return name_or_call();
    if (token.kind != Token::Kind::number) throw lexer_.expected("a number, a name or '('");
    lexer_.advance();
    return make_number(token.number);
}

NodePtr Parser::name_or_call() {
    const Token token = lexer_.current();
    lexer_.advance();
    NodePtr node;
    if (function_) {
        const auto& parameters = function_->parameters;
        const auto found = std::find(parameters.begin(), parameters.end(), token.text);
        if (found != parameters.end())
            node = make_leaf(Kind::parameter, static_cast<std::uint32_t>(found - parameters.begin()),
                             token.where);
    }
    if (!node) node = make_leaf(Kind::name, symbols_.refer(token.text, context_), token.where);
    if (lexer_.current().is('(')) {
        node = make_parent(Kind::call, std::move(node));
        do {
            lexer_.advance();
            add_child(*node, sum());
        } while (lexer_.current().is(','));
        expect(')');
    }
    return is_constant(*node) ? folded(std::move(node), token.where) : std::move(node);
}

std::uint32_t Parser::channel_number() {
    lexer_.advance();
    const Token token = lexer_.current();
    const bool whole = token.kind == Token::Kind::number && token.text.size() < 7 &&
                       token.text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!whole) throw lexer_.expected("the number of a channel");
    lexer_.advance();
    return static_cast<std::uint32_t>(token.number);
}

bool Parser::is_constant_function(const Node& node) const {
    if (node.kind != Kind::name) return false;
    const Symbol& symbol = symbols_[node.index];
    if (symbol.definition) return symbol.definition->is_function && symbol.definition->is_constant;
    if (symbol.intrinsic == Intrinsic::builtin) return symbols_.builtins()[symbol.builtin].pure;
    return symbol.intrinsic != Intrinsic::none;
}

bool Parser::is_constant(const Node& node) const {
    if (node.kind == Kind::name) {
        const Symbol& symbol = symbols_[node.index];
        return symbol.is_variable() && symbol.definition->is_constant;
    }
    if (node.kind != Kind::call || !is_constant_function(*node.children.front())) return false;
    return std::all_of(node.children.begin() + 1, node.children.end(), [this](const NodePtr& argument) {
        return argument->is_number() || is_constant_function(*argument);
    });
}

NodePtr Parser::folded(NodePtr node, const Location& where) {
    if (!evaluate_) return node;
    try {
        return make_number(evaluate_(*node));
    } catch (const Error& error) {
        if (!error.where().file.empty() || error.where().line > 0) throw;
        throw Error(where, error.message(), error.hint());
    }
}

}  // namespace infra::cal
