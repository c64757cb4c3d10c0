// Code for the vertices that are values: where they are found, and the instructions that compute them.
#include <algorithm>
#include <utility>

#include "cal/generator.h"

namespace infra::cal {
namespace {

constexpr std::uint32_t longest_index = 64;  // depth of an argument's number that is looked into
constexpr int worth_a_home = 4;              // cost below which a vertex is rather computed again

Opcode opcode_of(Op op) {
    switch (op) {
        case Op::negate:
            return Opcode::negate;
        case Op::add:
            return Opcode::add;
        case Op::subtract:
            return Opcode::subtract;
        case Op::multiply:
            return Opcode::multiply;
        case Op::divide:
            return Opcode::divide;
        case Op::power:
            return Opcode::power;
        case Op::minimum:
            return Opcode::minimum;
        case Op::maximum:
            return Opcode::maximum;
        case Op::square_root:
            return Opcode::square_root;
        case Op::floor:
            return Opcode::floor;
        case Op::ceiling:
            return Opcode::ceiling;
        case Op::sine:
            return Opcode::sine;
        case Op::cosine:
            return Opcode::cosine;
        case Op::arc_cosine:
            return Opcode::arc_cosine;
        case Op::arc_tangent2:
            return Opcode::arc_tangent2;
        case Op::arc_tangent2_or_zero:
            return Opcode::arc_tangent2_or_zero;
        default:
            return Opcode::fail;
    }
}

}  // namespace

Generator::Register Generator::emit(VertexId id) {
    const Vertex& vertex = graph_[id];
    if (vertex.op == Op::constant) return constant(vertex.number);
    if (available_[id] != unused) return available_[id];
    if (id != self_ && has_home(id)) return load_from_home(id);
    const Register reg = emit_here(id);
    remember(id, reg);
    return reg;
}

/// Whether a vertex is to be loaded rather than computed. A vertex that turns out to need a home gets it in
/// the next round; the code of this one is thrown away.
bool Generator::has_home(VertexId id) {
    const Vertex& vertex = graph_[id];
    if (is_shared_[id]) return true;
    if (vertex.cost < worth_a_home) return false;
    const bool in_instance = instance_ != no_instance;
    if (vertex.open ? ++times_emitted_[id] < 2 : !in_instance && ++times_emitted_[id] < 2) return false;
    is_shared_[id] = learnt_ = true;
    if (vertex.open) delayed_vertices_[instance_].push_back(id);
    return true;
}

Generator::Register Generator::load_from_home(VertexId id) {
    if (graph_[id].open) {
        const auto slot = delayed_slots_.find(id);
        if (slot == delayed_slots_.end()) return constant(0);  // learnt in this round
        add(Opcode::force, unused, slot->second);
        remember(id, slot->second);
        return slot->second;
    }
    const auto [cell, is_new] =
        cell_index_.try_emplace(id, static_cast<std::uint32_t>(cell_vertices_.size()));
    if (is_new) cell_vertices_.push_back(id);
    const Register dst = new_registers();
    add(Opcode::load_cell, dst, unused, unused, unused, cell->second);
    remember(id, dst);
    return dst;
}

Generator::Register Generator::emit_here(VertexId id) {
    const Vertex& vertex = graph_[id];
    switch (vertex.op) {
        case Op::parameter:
            return emit_parameter(vertex);
        case Op::add:
            return emit_sum(id);
        case Op::if_positive:
            return emit_if(id);
        case Op::select:
            return emit_select(id);
        case Op::call:
            return emit_call(id);
        case Op::builtin:
            return emit_builtin(id);
        case Op::argument:
            return emit_argument(id);
        case Op::channel: {
            const Register dst = new_registers();
            add(Opcode::channel, dst, unused, unused, unused, vertex.data);
            return dst;
        }
        case Op::fail:
            add(Opcode::fail, unused, unused, unused, unused, vertex.data);
            return constant(0);
        default:
            break;
    }
    Register dst;
    if (emit_clamp(id, dst)) return dst;
    const Register a = emit(vertex.inputs[0]);
    const Register b = vertex.inputs.size() > 1 ? emit(vertex.inputs[1]) : unused;
    dst = new_registers();
    add(opcode_of(vertex.op), dst, a, b);
    return dst;
}

Generator::Register Generator::emit_parameter(const Vertex& vertex) {
    Register slot = 0;
    for (std::uint32_t i = 0; i < vertex.data; ++i) slot += analysis_.is_delayed(vertex.scope, i) ? 3 : 1;
    if (analysis_.is_delayed(vertex.scope, vertex.data)) add(Opcode::force, unused, slot);
    return slot;
}

/// Whether a vertex is one of this kind that only the vertex being emitted needs, so that both can be one
/// instruction.
bool Generator::is_private(VertexId id, Op op) const {
    return graph_[id].op == op && analysis_.uses(id) == 1 && !at_hand(id) && !is_shared_[id];
}

bool Generator::is_constant(VertexId id, double value) const {
    return graph_[id].op == Op::constant && graph_[id].number == value;
}

/// max(min(x, high), low) with constants, and the arc cosine of it for -1 and 1.
bool Generator::emit_clamp(VertexId id, Register& dst) {
    const Vertex& outer = graph_[id];
    const bool arc_cosine = outer.op == Op::arc_cosine && is_private(outer.inputs[0], Op::maximum);
    if (!arc_cosine && outer.op != Op::maximum) return false;
    const Vertex& maximum = arc_cosine ? graph_[outer.inputs[0]] : outer;
    if (!is_private(maximum.inputs[0], Op::minimum) || graph_[maximum.inputs[1]].op != Op::constant)
        return false;
    const Vertex& minimum = graph_[maximum.inputs[0]];
    if (graph_[minimum.inputs[1]].op != Op::constant) return false;
    if (arc_cosine && !(is_constant(maximum.inputs[1], -1) && is_constant(minimum.inputs[1], 1)))
        return false;
    const Register x = emit(minimum.inputs[0]);
    dst = new_registers();
    if (arc_cosine)
        add(Opcode::arc_cosine_clamped, dst, x);
    else
        add(Opcode::clamp, dst, x, emit(maximum.inputs[1]), emit(minimum.inputs[1]));
    return true;
}

/// The sum of constant multiples of vertices that a vertex is, found through +, - and products with
/// constants.
struct Generator::AffineForm {
    double constant = 0;
    std::vector<std::pair<VertexId, double>> terms;

    void add(const Graph& graph, VertexId id, double factor) {
        const Vertex& vertex = graph[id];
        const auto is_number = [&graph](VertexId input) { return graph[input].op == Op::constant; };
        if (vertex.op == Op::constant) {
            constant += factor * vertex.number;
        } else if (vertex.op == Op::negate) {
            add(graph, vertex.inputs[0], -factor);
        } else if (vertex.op == Op::add || vertex.op == Op::subtract) {
            add(graph, vertex.inputs[0], factor);
            add(graph, vertex.inputs[1], vertex.op == Op::add ? factor : -factor);
        } else if (vertex.op == Op::multiply && is_number(vertex.inputs[0])) {
            add(graph, vertex.inputs[1], factor * graph[vertex.inputs[0]].number);
        } else if (vertex.op == Op::multiply && is_number(vertex.inputs[1])) {
            add(graph, vertex.inputs[0], factor * graph[vertex.inputs[1]].number);
        } else {
            const auto same = [id](const auto& term) { return term.first == id; };
            const auto known = std::find_if(terms.begin(), terms.end(), same);
            if (known == terms.end())
                terms.emplace_back(id, factor);
            else
                known->second += factor;
        }
    }
};

/// Interpolation between two real arguments whose numbers differ by a constant, as in every table.
bool Generator::emit_table_step(VertexId t, VertexId from, VertexId to, Register& dst) {
    if (!is_private(from, Op::argument) || !is_private(to, Op::argument)) return false;
    const VertexId first = graph_[from].inputs[0], second = graph_[to].inputs[0];
    if (analysis_.depth(first) > longest_index || analysis_.depth(second) > longest_index) return false;
    AffineForm one, other;
    one.add(graph_, first, 1);
    other.add(graph_, second, 1);
    if (one.terms.empty() || one.terms.size() > 2 || one.terms != other.terms) return false;
    const auto [p, p_factor] = one.terms.front();
    const auto [q, q_factor] = one.terms.size() == 2 ? one.terms.back() : std::pair<VertexId, double>(p, 0);
    const Register weight = emit(t), a = emit(p), b = emit(q);
    dst = new_registers();
    add(Opcode::interpolate_arguments, dst, a, b,
        constants({one.constant, p_factor, q_factor, other.constant}), weight);
    return true;
}

// a*b + c and (1-t)*a + t*b in one instruction, where the parts are not needed by themselves.
Generator::Register Generator::emit_sum(VertexId id) {
    const auto private_product = [this](VertexId input) { return is_private(input, Op::multiply); };
    const VertexId left = graph_[id].inputs[0], right = graph_[id].inputs[1];
    if (left != right && private_product(left) && private_product(right)) {
        const Vertex& complement = graph_[graph_[left].inputs[0]];
        const VertexId t = graph_[right].inputs[0];
        const bool interpolates = complement.op == Op::subtract && complement.inputs[1] == t &&
                                  is_constant(complement.inputs[0], 1);
        Register table_value;
        if (interpolates && emit_table_step(t, graph_[left].inputs[1], graph_[right].inputs[1], table_value))
            return table_value;
        if (interpolates) {
            const Register a = emit(t), b = emit(graph_[left].inputs[1]), c = emit(graph_[right].inputs[1]);
            const Register dst = new_registers();
            add(Opcode::interpolate, dst, a, b, c);
            return dst;
        }
    }
    for (const bool swapped : {false, true}) {
        const VertexId product = swapped ? right : left, other = swapped ? left : right;
        if (product == other || !private_product(product)) continue;
        const Register a = emit(graph_[product].inputs[0]), b = emit(graph_[product].inputs[1]),
                       c = emit(other);
        const Register dst = new_registers();
        add(Opcode::multiply_add, dst, a, b, c);
        return dst;
    }
    const Register a = emit(left), b = emit(right);
    const Register dst = new_registers();
    add(Opcode::add, dst, a, b);
    return dst;
}

Generator::Register Generator::emit_argument(VertexId id) {
    constexpr double largest = 1e6;
    const Vertex& number = graph_[graph_[id].inputs[0]];
    const Register dst = new_registers();
    if (number.op == Op::constant && number.number >= .5 && number.number < largest)
        add(Opcode::argument_constant, dst, unused, unused, unused,
            static_cast<std::uint32_t>(number.number + .5) - 1);
    else if (!emit_affine_argument(graph_[id].inputs[0], dst))
        add(Opcode::argument, dst, emit(graph_[id].inputs[0]));
    return dst;
}

/// Tables are read by arg(n*i + j + 1) and the like: one instruction where the number has at most two
/// variable terms.
bool Generator::emit_affine_argument(VertexId number, Register dst) {
    if (at_hand(number) || is_shared_[number] || analysis_.depth(number) > longest_index) return false;
    AffineForm form;
    form.add(graph_, number, 1);
    if (form.terms.empty() || form.terms.size() > 2 || form.terms.front().first == number) return false;
    const bool one = form.terms.size() == 1;
    const Register a = emit(form.terms.front().first), b = one ? a : emit(form.terms.back().first);
    add(Opcode::argument_affine, dst, a, b,
        constants({form.constant, form.terms.front().second, one ? 0 : form.terms.back().second}));
    return true;
}

Generator::Register Generator::emit_builtin(VertexId id) {
    const Vertex& vertex = graph_[id];
    std::vector<Register> arguments;
    for (const VertexId input : vertex.inputs) arguments.push_back(emit(input));
    const Register block = new_registers(std::max<Register>(1, static_cast<Register>(arguments.size())));
    for (std::size_t i = 0; i < arguments.size(); ++i)
        emit_move(block + static_cast<Register>(i), arguments[i]);
    const Register dst = new_registers();
    add(Opcode::builtin, dst, block, unused, unused, vertex.data);
    return dst;
}

}  // namespace infra::cal
