#include "cal/graph.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace infra::cal {
namespace {

void mix(std::size_t& hash, std::uint64_t value) {
    hash ^= value + 0x9e3779b97f4a7c15u + (hash << 6) + (hash >> 2);
}

std::uint16_t own_cost(Op op) {
    switch (op) {
        case Op::constant:
            return 0;
        case Op::parameter:
            return 0;
        case Op::fail:
            return 0;
        case Op::channel:
            return 4;
        case Op::divide:
            return 3;
        case Op::square_root:
            return 4;
        case Op::power:
        case Op::sine:
        case Op::cosine:
        case Op::arc_cosine:
        case Op::arc_tangent2:
        case Op::arc_tangent2_or_zero:
        case Op::builtin:
            return 20;
        case Op::call:
            return 100;
        default:
            return 1;
    }
}

}  // namespace

std::size_t Graph::Hash::operator()(const Vertex& vertex) const {
    std::size_t hash = static_cast<std::size_t>(vertex.op);
    mix(hash, vertex.data);
    mix(hash, vertex.scope);
    mix(hash, std::bit_cast<std::uint64_t>(vertex.number));
    for (const VertexId input : vertex.inputs) mix(hash, input);
    return hash;
}

bool Graph::Equal::operator()(const Vertex& a, const Vertex& b) const {
    return a.op == b.op && a.data == b.data && a.scope == b.scope &&
           std::bit_cast<std::uint64_t>(a.number) == std::bit_cast<std::uint64_t>(b.number) &&
           a.inputs == b.inputs;
}

std::uint16_t Graph::total_cost(const Vertex& vertex) const {
    unsigned cost = own_cost(vertex.op);
    for (const VertexId input : vertex.inputs) cost += vertices_[input].cost;
    return static_cast<std::uint16_t>(std::min(cost, 10000u));
}

VertexId Graph::intern(Vertex vertex) {
    if (const auto found = known_.find(vertex); found != known_.end()) return found->second;
    vertex.cost = total_cost(vertex);
    for (const VertexId input : vertex.inputs) vertex.open = vertex.open || vertices_[input].open;
    const auto id = static_cast<VertexId>(vertices_.size());
    known_.emplace(vertex, id);
    vertices_.push_back(std::move(vertex));
    return id;
}

VertexId Graph::constant(double value) {
    Vertex vertex;
    vertex.number = value;
    return intern(std::move(vertex));
}

VertexId Graph::parameter(std::uint32_t scope, std::uint32_t number) {
    Vertex vertex;
    vertex.op = Op::parameter;
    vertex.open = true;
    vertex.scope = scope;
    vertex.data = number;
    return intern(std::move(vertex));
}

bool Graph::is_constant(VertexId id, double value) const {
    return vertices_[id].op == Op::constant && vertices_[id].number == value;
}

bool Graph::fold(const Vertex& vertex, double& value) const {
    const auto constant_input = [this](VertexId id) { return vertices_[id].op == Op::constant; };
    if (!std::all_of(vertex.inputs.begin(), vertex.inputs.end(), constant_input)) return false;
    const auto input = [&](std::size_t i) { return vertices_[vertex.inputs[i]].number; };
    switch (vertex.op) {
        case Op::negate:
            value = -input(0);
            return true;
        case Op::add:
            value = input(0) + input(1);
            return true;
        case Op::subtract:
            value = input(0) - input(1);
            return true;
        case Op::multiply:
            value = input(0) * input(1);
            return true;
        case Op::divide:
            value = input(0) / input(1);
            return input(1) != 0;
        case Op::power:
            value = std::pow(input(0), input(1));
            break;
        case Op::minimum:
            value = smaller(input(0), input(1));
            return true;
        case Op::maximum:
            value = larger(input(0), input(1));
            return true;
        case Op::square_root:
            value = std::sqrt(input(0));
            break;
        case Op::floor:
            value = std::floor(input(0));
            break;
        case Op::ceiling:
            value = std::ceil(input(0));
            break;
        case Op::sine:
            value = std::sin(input(0));
            break;
        case Op::cosine:
            value = std::cos(input(0));
            break;
        case Op::arc_cosine:
            value = std::acos(input(0));
            break;
        case Op::arc_tangent2:
        case Op::arc_tangent2_or_zero:
            value = std::atan2(input(0), input(1));
            break;
        case Op::builtin: {
            const Builtin& builtin = builtins_[vertex.data];
            if (!builtin.pure) return false;
            std::vector<double> arguments;
            for (std::size_t i = 0; i < vertex.inputs.size(); ++i) arguments.push_back(input(i));
            value = builtin.call(arguments.data(), Host{});
            break;
        }
        default:
            return false;
    }
    return std::isfinite(value);
}

bool Graph::simplify(Op op, std::span<const VertexId> inputs, VertexId& result) {
    if (op == Op::if_positive) return simplify_if(inputs, result);
    if (op == Op::multiply && is_constant(inputs[0], 1)) return result = inputs[1], true;
    if ((op == Op::multiply || op == Op::divide || op == Op::power) && is_constant(inputs[1], 1))
        return result = inputs[0], true;
    if (op == Op::power && is_constant(inputs[1], 2))
        return result = make(Op::multiply, {inputs[0], inputs[0]}), true;
    if (op == Op::power && is_constant(inputs[1], 3)) {
        const VertexId base = inputs[0];
        return result = make(Op::multiply, {make(Op::multiply, {base, base}), base}), true;
    }
    if (op == Op::select && vertices_[inputs[0]].op == Op::constant) {
        const int count = static_cast<int>(inputs.size()) - 1;
        const int choice = selected(vertices_[inputs[0]].number, count);
        if (choice < 0) return false;
        return result = choice == 0 ? constant(count) : inputs[static_cast<std::size_t>(choice)], true;
    }
    return false;
}

bool Graph::simplify_if(std::span<const VertexId> inputs, VertexId& result) {
    const VertexId yes = inputs[1], no = inputs[2];
    const Vertex& condition = vertices_[inputs[0]];
    if (condition.op == Op::constant) return result = condition.number > 0 ? yes : no, true;
    const Vertex& first = vertices_[yes];
    if (first.op == Op::arc_tangent2 && is_constant(no, 0) &&
        is_sum_of_squares(condition, first.inputs[0], first.inputs[1]))
        return result = make(Op::arc_tangent2_or_zero, {first.inputs[0], first.inputs[1]}), true;
    if (condition.op != Op::subtract) return false;
    const VertexId a = condition.inputs[0], b = condition.inputs[1];
    if (yes == a && no == b) return result = make(Op::maximum, {b, a}), true;  // if(a-b, a, b)
    if (yes == b && no == a) return result = make(Op::minimum, {a, b}), true;  // if(a-b, b, a)
    // if(low-x, low, min(x, high)) with constants low <= high is max(min(x, high), low)
    const Vertex& other = vertices_[no];
    if (yes == a && other.op == Op::minimum && other.inputs[0] == b && vertices_[a].op == Op::constant) {
        const Vertex& high = vertices_[other.inputs[1]];
        if (high.op == Op::constant && vertices_[a].number <= high.number)
            return result = make(Op::maximum, {no, a}), true;
    }
    return false;
}

bool Graph::is_sum_of_squares(const Vertex& vertex, VertexId a, VertexId b) const {
    const auto is_square = [this](VertexId id, VertexId of) {
        return vertices_[id].op == Op::multiply && vertices_[id].inputs[0] == of &&
               vertices_[id].inputs[1] == of;
    };
    if (vertex.op != Op::add) return false;
    const VertexId left = vertex.inputs[0], right = vertex.inputs[1];
    return (is_square(left, a) && is_square(right, b)) || (is_square(left, b) && is_square(right, a));
}

VertexId Graph::make(Op op, std::vector<VertexId> inputs, std::uint32_t data) {
    VertexId simpler;
    if (simplify(op, inputs, simpler)) return simpler;
    Vertex vertex;
    vertex.op = op;
    vertex.data = data;
    vertex.inputs = std::move(inputs);
    double value;
    if (!vertex.inputs.empty() && fold(vertex, value)) return constant(value);
    return intern(std::move(vertex));
}

}  // namespace infra::cal
