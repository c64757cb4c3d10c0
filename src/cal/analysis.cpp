#include "cal/analysis.h"

#include <algorithm>

namespace infra::cal {

Analysis::Analysis(const Lowering& lowered)
    : graph_(lowered.graph()), uses_(graph_.size()), depths_(graph_.size(), 1) {
    for (const Instance& instance : lowered.instances())
        delayed_.emplace_back(instance.parameter_count, false);
    std::vector<VertexId> calls;
    for (VertexId id = 0; id < graph_.size(); ++id) {
        for (const VertexId input : graph_[id].inputs) {  // inputs are made before what needs them
            ++uses_[input];
            depths_[id] = std::max(depths_[id], depths_[input] + 1);
        }
        if (graph_[id].op == Op::call) calls.push_back(id);
    }
    // Suppose none is delayed; then look for calls that show the contrary until nothing changes.
    for (bool changed = true; changed;) {
        changed = false;
        for (const VertexId id : calls) {
            const Vertex& call = graph_[id];
            for (std::size_t i = 0; i < call.inputs.size(); ++i) {
                if (delayed_[call.data][i] || is_safe(call.inputs[i])) continue;
                delayed_[call.data][i] = true;
                changed = true;
            }
        }
    }
}

bool Analysis::is_safe(VertexId id) const {
    constexpr int costly = 30;
    const Vertex& vertex = graph_[id];
    if (vertex.cost > costly) return false;
    switch (vertex.op) {
        case Op::parameter:
            return !delayed_[vertex.scope][vertex.data];
        case Op::divide: {
            const Vertex& divisor = graph_[vertex.inputs[1]];
            if (divisor.op != Op::constant || divisor.number == 0) return false;
            break;
        }
        case Op::power:
        case Op::square_root:
        case Op::arc_cosine:
        case Op::argument:
        case Op::builtin:
        case Op::select:
        case Op::call:
        case Op::fail:
            return false;
        default:
            break;
    }
    return std::all_of(vertex.inputs.begin(), vertex.inputs.end(),
                       [this](VertexId input) { return is_safe(input); });
}

void Analysis::collect_needed(VertexId id, std::unordered_set<VertexId>& seen,
                              std::vector<VertexId>& order) const {
    const Vertex& vertex = graph_[id];
    if (vertex.cost == 0 || !seen.insert(id).second) return;
    std::size_t certain = vertex.inputs.size();
    if (vertex.op == Op::if_positive || vertex.op == Op::select) certain = 1;
    if (vertex.op == Op::call) certain = 0;
    for (std::size_t i = 0; i < certain; ++i) collect_needed(vertex.inputs[i], seen, order);
    order.push_back(id);
}

std::vector<VertexId> Analysis::needed_by_both(VertexId yes, VertexId no) const {
    std::unordered_set<VertexId> by_yes, by_no;
    std::vector<VertexId> order, unused;
    collect_needed(yes, by_yes, order);
    collect_needed(no, by_no, unused);
    std::erase_if(order, [&](VertexId id) { return !by_no.contains(id); });
    return order;
}

}  // namespace infra::cal
