// What a tensor tree scatters light from one direction to: the cells that share an incident direction, with
// sums for sampling. Incident directions that see the same cells share a slice.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/disk_square.h"
#include "bsdf/tensor_tree.h"

namespace infra {

class SliceSet {
  public:
    /// More cells in all slices together than any sensible tree has: 1.5 GB of tables.
    static constexpr std::size_t most_cells = std::size_t(1) << 27;

    /// A square of the square of outgoing directions.
    struct Square {
        Point2 corner;
        double width;
    };
    struct Slice {
        std::uint32_t begin = 0, end = 0;  ///< of its cells
        double total = 0;                  ///< mean value times pi
        double least_width = 1, largest_width = 0;
    };

    ///   from_outgoing  slices for light that comes from the outgoing side, for trees of rank 4
    ///   throws         Error for a tree too detailed to be sampled
    SliceSet(const TensorTree& tree, bool from_outgoing);

    /// The slice of an incident direction: its square's place, or for rank 3 the first coordinate alone.
    const Slice& slice_at(const Point2& incident) const;
    /// Chooses one of a slice's cells with a chance in proportion to its value times its area. choice: 0..1.
    Square choose(const Slice& slice, double choice) const;

    double largest_total() const { return largest_total_; }
    double least_width() const { return least_width_; }

  private:
    struct Region {
        double width;
        std::uint32_t first = 0;  ///< of its parts, or its slice
        bool divided = false;
    };
    struct Cell {
        std::uint16_t x, y;  ///< corner in units of 2^-finest
        std::uint8_t level;  ///< width 2^-level
    };
    struct Place {
        Point2 incident;  ///< corner of a region
        double width;
    };

    void fill(std::size_t region, const Place& place);
    bool gather(std::size_t node, const TreePoint& corner, double width, const Place& place);
    bool gather_children(const TensorTree::Node& node, const TreePoint& corner, double width,
                         const Place& place);
    void gather_grid(const TensorTree::Node& node, const TreePoint& corner, double step, const Place& place);
    void add_cell(const TreePoint& corner, double width, float value);
    Slice finish_slice();

    const TensorTree* tree_;  // while the set is built
    std::size_t incident_count_;
    std::size_t incident_first_, outgoing_first_;  // of the tree's coordinates
    bool turned_;
    std::vector<float> pending_;  // values of the slice under way

    std::vector<Region> regions_;
    std::vector<Slice> slices_;
    std::vector<Cell> cells_;
    std::vector<float> cumulative_;  ///< by cell: of value times area over the slice
    double largest_total_ = 0, least_width_ = 1;
};

}  // namespace infra
