// Syntax trees of expressions, as the parser builds them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/error.h"

namespace infra::cal {

/// Names one entry of a SymbolTable.
using SymbolId = std::uint32_t;

struct Node;
using NodePtr = std::unique_ptr<Node>;

struct Node {
    enum class Kind {
        number,
        channel,
        parameter,
        name,
        call,
        negate,
        add,
        subtract,
        multiply,
        divide,
        power
    };

    Kind kind = Kind::number;
    double number = 0;        ///< number: its value
    std::uint32_t index = 0;  ///< channel: its number; parameter: from 0; name: its SymbolId
    std::vector<NodePtr>
        children;    ///< operands; call: what is called (a name or parameter), then the arguments
    Location where;  ///< of a name or parameter, for errors found late
    int depth = 1;   ///< nodes on the longest way down, this one included

    bool is_number() const { return kind == Kind::number; }
    bool is_number(double value) const { return kind == Kind::number && number == value; }
};

/// `name = body`, `name : body`, `name(parameters) = body` or `name(parameters) : body`.
struct Definition {
    bool is_function = false;
    bool is_constant = false;  ///< written with ':'
    std::vector<std::string> parameters;
    NodePtr body;
};

/// Builds nodes. Operators on numbers are left alone: folding is the parser's decision.
NodePtr make_number(double value);
NodePtr make_leaf(Node::Kind kind, std::uint32_t index, const Location& where);
NodePtr make_parent(Node::Kind kind, NodePtr first, NodePtr second = nullptr);
void add_child(Node& parent, NodePtr child);

}  // namespace infra::cal
