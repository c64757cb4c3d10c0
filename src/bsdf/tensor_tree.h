// A function on the unit cube of three or four dimensions, constant over cells that are the finer the more it
// changes: RADIANCE's tensor tree. A node is either divided in halves along every dimension, or a grid of
// 2^k cells along each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace infra {

/// A place in the unit cube, or the lowest corner of a cell; a tree of rank 3 uses the first three.
using TreePoint = std::array<double, 4>;

class TensorTree {
  public:
    /// Cells are not smaller than 2^-finest of the cube.
    static constexpr int finest = 16;

    struct Node {
        static constexpr int divided = -1;
        std::uint32_t first = 0;  ///< among the nodes if divided (2^rank follow one another), else the values
        int log2_grid = divided;  ///< of a grid's cells along each dimension
    };

    ///   rank   3 or 4
    ///   nodes  the first is the root; bit i of a child's number says which half of coordinate i it is
    ///   values of grids, the first coordinate varies most slowly
    TensorTree(int rank, std::vector<Node> nodes, std::vector<float> values);

    int rank() const { return rank_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    float value(std::size_t index) const { return values_[index]; }

    struct Cell {
        std::size_t index = 0;  ///< of its value
        double width = 1;
    };
    /// The cell at a place whose coordinates are in 0 <= x < 1.
    Cell cell_at(const TreePoint& place) const;
    float value_at(const TreePoint& place) const { return values_[cell_at(place).index]; }

    /// Calls visit(corner, width, value index) for every cell.
    template <class Visit>
    void visit_cells(const Visit& visit) const {
        visit_from(0, {}, 1.0, visit);
    }

    /// Subtracts from all values, none of which becomes negative.
    void subtract(float amount);

  private:
    template <class Visit>
    void visit_from(std::size_t node, const TreePoint& corner, double width, const Visit& visit) const;

    int rank_;
    std::vector<Node> nodes_;
    std::vector<float> values_;
};

template <class Visit>
void TensorTree::visit_from(std::size_t number, const TreePoint& corner, double width,
                            const Visit& visit) const {
    const Node& node = nodes_[number];
    if (node.log2_grid == Node::divided) {
        for (std::size_t child = 0; child < std::size_t(1) << rank_; ++child) {
            TreePoint at = corner;
            for (std::size_t i = 0; i < at.size(); ++i)
                if (child >> i & 1) at[i] += 0.5 * width;
            visit_from(node.first + child, at, 0.5 * width, visit);
        }
        return;
    }
    const std::size_t side = std::size_t(1) << node.log2_grid, mask = side - 1;
    const double step = width / static_cast<double>(side);
    for (std::size_t n = 0; n < std::size_t(1) << node.log2_grid * rank_; ++n) {
        TreePoint at = corner;
        for (int i = 0; i < rank_; ++i)
            at[static_cast<std::size_t>(i)] +=
                step * static_cast<double>(n >> node.log2_grid * (rank_ - 1 - i) & mask);
        visit(at, step, node.first + n);
    }
}

}  // namespace infra
