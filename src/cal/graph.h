// Expressions as a graph in which equal subexpressions are one vertex: what lowering makes and code comes
// from.
//
// A vertex is a value that is computed where and when it is first needed; only code generation decides where.
// A vertex is closed when it is the same for everything evaluated within one clock, and open when it depends
// on the parameters of a function that could not be inlined.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "cal/builtin.h"

namespace infra::cal {

using VertexId = std::uint32_t;

enum class Op : std::uint8_t {
    constant,   ///< number
    parameter,  ///< data: which parameter; the instance it belongs to makes up `scope`
    channel,    ///< data: number
    argument,   ///< arg(input)
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    minimum,
    maximum,
    square_root,
    floor,
    ceiling,
    sine,
    cosine,
    arc_cosine,
    arc_tangent2,
    arc_tangent2_or_zero,  ///< atan2, but 0 where both inputs are 0
    builtin,               ///< data: index among the builtins; inputs: its arguments
    if_positive,           ///< inputs: condition, then, else
    select,                ///< inputs: index, alternatives 1, 2, ...
    call,                  ///< data: instance; inputs: its arguments
    fail,                  ///< data: index among the errors
};

struct Vertex {
    Op op = Op::constant;
    bool open = false;
    std::uint16_t cost = 0;  ///< rough cost of computing it with all that it needs, in additions, saturating
    std::uint32_t data = 0;
    std::uint32_t scope = 0;  ///< keeps the parameters of different instances apart
    double number = 0;
    std::vector<VertexId> inputs;
};

class Graph {
  public:
    explicit Graph(std::span<const Builtin> builtins) : builtins_(builtins) {}

    VertexId constant(double value);
    VertexId parameter(std::uint32_t scope, std::uint32_t number);

    /// The vertex for an operation, an equal one if there is one already. Simplifies: constants are folded
    /// where that raises no error, and bound(a, x, b) becomes a minimum and a maximum.
    VertexId make(Op op, std::vector<VertexId> inputs, std::uint32_t data = 0);

    const Vertex& operator[](VertexId id) const { return vertices_[id]; }
    std::size_t size() const { return vertices_.size(); }
    std::span<const Builtin> builtins() const { return builtins_; }

  private:
    struct Hash {
        std::size_t operator()(const Vertex& vertex) const;
    };
    struct Equal {
        bool operator()(const Vertex& a, const Vertex& b) const;
    };

    VertexId intern(Vertex vertex);
    bool is_constant(VertexId id, double value) const;
    bool fold(const Vertex& vertex, double& value) const;
    bool simplify(Op op, std::span<const VertexId> inputs, VertexId& result);
    bool simplify_if(std::span<const VertexId> inputs, VertexId& result);
    bool is_sum_of_squares(const Vertex& vertex, VertexId a, VertexId b) const;
    std::uint16_t total_cost(const Vertex& vertex) const;

    std::span<const Builtin> builtins_;
    std::vector<Vertex> vertices_;
    std::unordered_map<Vertex, VertexId, Hash, Equal> known_;
};

/// select(index, ...) with `count` alternatives: the alternative's number from 1, 0 for their count, -1
/// outside.
inline int selected(double index, int count) {
    if (!(index >= -.5) || !(index + .5 < count + 1.)) return -1;
    return static_cast<int>(index + .5);
}

/// max and min in RADIANCE's order of comparison, which decides what NaN does.
inline double larger(double a, double b) { return a < b ? b : a; }
inline double smaller(double a, double b) { return a > b ? b : a; }

}  // namespace infra::cal
