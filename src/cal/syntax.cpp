#include "cal/syntax.h"

#include <algorithm>

namespace infra::cal {

NodePtr make_number(double value) {
    auto node = std::make_unique<Node>();
    node->number = value;
    return node;
}

NodePtr make_leaf(Node::Kind kind, std::uint32_t index, const Location& where) {
    auto node = std::make_unique<Node>();
    node->kind = kind;
    node->index = index;
    node->where = where;
    return node;
}

NodePtr make_parent(Node::Kind kind, NodePtr first, NodePtr second) {
    auto node = std::make_unique<Node>();
    node->kind = kind;
    node->where = first->where;
    add_child(*node, std::move(first));
    if (second) add_child(*node, std::move(second));
    return node;
}

void add_child(Node& parent, NodePtr child) {
    parent.depth = std::max(parent.depth, child->depth + 1);
    parent.children.push_back(std::move(child));
}

}  // namespace infra::cal
