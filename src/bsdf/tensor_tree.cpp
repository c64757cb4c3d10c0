#include "bsdf/tensor_tree.h"

#include <algorithm>

namespace infra {

TensorTree::TensorTree(int rank, std::vector<Node> nodes, std::vector<float> values)
    : rank_(rank), nodes_(std::move(nodes)), values_(std::move(values)) {}

TensorTree::Cell TensorTree::cell_at(const TreePoint& place) const {
    TreePoint at = place;
    const auto rank = static_cast<std::size_t>(rank_);
    double width = 1;
    const Node* node = &nodes_.front();
    while (node->log2_grid == Node::divided) {
        std::size_t child = 0;
        for (std::size_t i = 0; i < rank; ++i) {
            at[i] *= 2;
            if (at[i] < 1) continue;
            at[i] -= 1;
            child |= std::size_t(1) << i;
        }
        width *= 0.5;
        node = &nodes_[node->first + child];
    }
    const double side = static_cast<double>(std::size_t(1) << node->log2_grid);
    std::size_t n = 0;
    for (std::size_t i = 0; i < rank; ++i)
        n = (n << node->log2_grid) + static_cast<std::size_t>(at[i] * side);
    return {node->first + n, width / side};
}

void TensorTree::subtract(float amount) {
    for (float& value : values_) value = std::max(0.0f, value - amount);
}

}  // namespace infra
