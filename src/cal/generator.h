// Turns a graph into code.
//
// Within a body each vertex is computed where it is first needed and kept in a register for what follows on
// the same path. One that would be computed in two places is given a home: a cell if it is closed (so that a
// variable is evaluated once a clock, however many expressions use it), else a delayed value in its
// instance's frame. Those places are found by generating the code, so it is generated again until no new ones
// turn up.
#pragma once

#include <initializer_list>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cal/analysis.h"
#include "cal/code.h"
#include "cal/lowering.h"

namespace infra::cal {

/// What an ExprId stands for: a closed vertex, or an instance with its parameters.
struct RootSource {
    bool is_instance = false;
    std::uint32_t id = 0;
};

class Generator {
  public:
    Generator(const Lowering& lowered, std::vector<RootSource> roots);
    Code generate();

  private:
    using Register = std::uint32_t;

    static constexpr Register unused = 0xffffffff;
    static constexpr Register constant_flag =
        0x80000000;  ///< marks the number of a constant, not of a register
    static constexpr std::uint32_t no_instance = 0xffffffff;
    static constexpr VertexId no_vertex = 0xffffffff;
    static constexpr std::uint32_t no_jump = 0xffffffff;

    /// A stretch of code whose registers still have to be given their final numbers.
    struct Body {
        std::uint32_t begin = 0, end = 0;
        std::uint32_t instance = no_instance;
        bool is_cell = false;
        Register registers = 0;
    };

    struct AffineForm;

    bool generate_round();
    void root_or_cell_body(VertexId vertex, bool is_cell);
    void instance_body(std::uint32_t instance);
    void begin_body(std::uint32_t instance, std::vector<double>& constants);
    void end_body(std::uint32_t begin, bool is_cell);
    std::uint32_t want_instance(std::uint32_t instance);
    void place_bodies();
    void pass_on_last_values();
    void place(const Body& body, Register base);
    Register stack_registers() const;

    Register emit(VertexId id);
    Register emit_here(VertexId id);
    Register emit_sum(VertexId id);
    bool emit_clamp(VertexId id, Register& dst);
    bool emit_table_step(VertexId t, VertexId from, VertexId to, Register& dst);
    bool emit_affine_argument(VertexId id, Register dst);
    Register emit_if(VertexId id);
    Register emit_select(VertexId id);
    Register emit_call(VertexId id);
    Register emit_builtin(VertexId id);
    Register emit_argument(VertexId id);
    Register emit_parameter(const Vertex& vertex);
    void emit_finish(VertexId id);
    std::uint32_t emit_branch(VertexId id, Register& positive);
    Register emit_choice(VertexId id, Register positive);
    void emit_move(Register dst, Register from);
    void emit_delayed(Register slot, VertexId id);

    bool has_home(VertexId id);
    Register load_from_home(VertexId id);
    bool can_choose(VertexId id, int& budget) const;
    bool is_private(VertexId id, Op op) const;
    bool is_constant(VertexId id, double value) const;
    bool is_branching(VertexId id) const;
    bool at_hand(VertexId id) const { return id == self_ ? false : available_[id] != unused; }

    Register constant(double value);
    Register constants(std::initializer_list<double> values);
    Register new_registers(Register count = 1);
    std::uint32_t add(Opcode opcode, Register dst, Register a = unused, Register b = unused,
                      Register c = unused, std::uint32_t data = 0);
    std::uint32_t here() const { return static_cast<std::uint32_t>(code_.instructions.size()); }
    void remember(VertexId id, Register reg);
    void forget_back_to(std::size_t mark);

    const Lowering& lowered_;
    const Graph& graph_;
    Analysis analysis_;
    std::vector<RootSource> roots_;
    std::vector<bool> is_shared_;                          ///< vertices with a home, learnt over the rounds
    std::vector<std::vector<VertexId>> delayed_vertices_;  ///< by instance

    // One round.
    Code code_;
    bool learnt_ = false;
    std::vector<std::uint32_t> times_emitted_;
    std::unordered_map<VertexId, std::uint32_t> cell_index_;
    std::vector<VertexId> cell_vertices_;
    std::vector<bool> instance_wanted_;
    std::vector<std::uint32_t> wanted_instances_;
    std::vector<Body> bodies_;
    std::map<std::pair<const void*, std::uint64_t>, Register> constant_index_;

    // One body.
    std::uint32_t instance_ = no_instance;
    VertexId self_ = no_vertex;  ///< the vertex whose home is being filled
    Register next_register_ = 0;
    std::vector<double>* constants_ = nullptr;  ///< those of the instance, or the common ones
    std::unordered_map<VertexId, Register> delayed_slots_;
    std::vector<Register> available_;  ///< by vertex
    std::vector<VertexId> trail_;      ///< vertices made available, in order
};

}  // namespace infra::cal
