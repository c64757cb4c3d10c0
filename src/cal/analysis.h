// Questions about a graph that code generation asks.
#pragma once

#include <unordered_set>
#include <vector>

#include "cal/graph.h"
#include "cal/lowering.h"

namespace infra::cal {

class Analysis {
  public:
    explicit Analysis(const Lowering& lowered);

    /// Whether a parameter may have to be passed as a delayed value, because computing an argument that is
    /// not needed after all could fail, go on for ever or take long.
    bool is_delayed(std::uint32_t instance, std::uint32_t parameter) const {
        return delayed_[instance][parameter];
    }

    /// How often a vertex is an input of another.
    std::uint32_t uses(VertexId id) const { return uses_[id]; }

    /// Vertices on the longest way down from one, itself included.
    std::uint32_t depth(VertexId id) const { return depths_[id]; }

    /// The vertices, inputs first, that both branches need whatever happens.
    std::vector<VertexId> needed_by_both(VertexId yes, VertexId no) const;

  private:
    bool is_safe(VertexId id) const;
    void collect_needed(VertexId id, std::unordered_set<VertexId>& seen, std::vector<VertexId>& order) const;

    const Graph& graph_;
    std::vector<std::vector<bool>> delayed_;
    std::vector<std::uint32_t> uses_;
    std::vector<std::uint32_t> depths_;
};

}  // namespace infra::cal
