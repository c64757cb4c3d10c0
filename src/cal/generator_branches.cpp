// Code for the vertices that decide what is computed: if, select, and calls with delayed arguments.
#include <algorithm>

#include "cal/generator.h"

namespace infra::cal {
namespace {

constexpr int choice_budget = 6;  // cost up to which both branches of an if are computed instead of jumping

}  // namespace

/// Whether a vertex may be computed although it might not be needed: it cannot fail, and what it needs beyond
/// what is at hand costs no more than the budget.
bool Generator::can_choose(VertexId id, int& budget) const {
    const Vertex& vertex = graph_[id];
    if (vertex.op == Op::constant || at_hand(id)) return true;
    if (--budget < 0 || is_shared_[id]) return false;
    switch (vertex.op) {
        case Op::parameter:
            return !analysis_.is_delayed(vertex.scope, vertex.data);
        case Op::negate:
        case Op::add:
        case Op::subtract:
        case Op::multiply:
        case Op::minimum:
        case Op::maximum:
            break;
        default:
            return false;
    }
    return std::all_of(vertex.inputs.begin(), vertex.inputs.end(),
                       [&](VertexId input) { return can_choose(input, budget); });
}

/// Emits what an if certainly needs: its condition and what its branches have in common. Then, unless both
/// branches are cheap enough to be computed in any case, a jump still without target to the second one.
///   returns  place of the jump, or no_jump; the condition is in `positive` then
std::uint32_t Generator::emit_branch(VertexId id, Register& positive) {
    const std::vector<VertexId>& inputs = graph_[id].inputs;
    const VertexId condition = inputs[0];
    const bool compares =
        graph_[condition].op == Op::subtract && !at_hand(condition) && !is_shared_[condition];
    const Register a = emit(compares ? graph_[condition].inputs[0] : condition);
    const Register b = compares ? emit(graph_[condition].inputs[1]) : unused;
    for (const VertexId common : analysis_.needed_by_both(inputs[1], inputs[2])) emit(common);
    int budget = choice_budget;
    if (can_choose(inputs[1], budget) && can_choose(inputs[2], budget)) {
        positive = emit(condition);
        return no_jump;
    }
    return add(compares ? Opcode::jump_unless_greater : Opcode::jump_unless_positive, unused, a, b);
}

Generator::Register Generator::emit_choice(VertexId id, Register positive) {
    const Register b = emit(graph_[id].inputs[1]), c = emit(graph_[id].inputs[2]);
    const Register dst = new_registers();
    add(Opcode::choose, dst, positive, b, c);
    return dst;
}

bool Generator::is_branching(VertexId id) const {
    if (graph_[id].op != Op::if_positive || at_hand(id)) return false;
    return id == self_ || !is_shared_[id];
}

Generator::Register Generator::emit_if(VertexId id) {
    Register positive;
    const std::uint32_t branch = emit_branch(id, positive);
    if (branch == no_jump) return emit_choice(id, positive);
    const Register dst = new_registers();
    const std::size_t mark = trail_.size();
    emit_move(dst, emit(graph_[id].inputs[1]));
    const std::uint32_t end = add(Opcode::jump, unused);
    forget_back_to(mark);
    code_.instructions[branch].data = here();
    emit_move(dst, emit(graph_[id].inputs[2]));
    forget_back_to(mark);
    code_.instructions[end].data = here();
    return dst;
}

/// Computes a vertex and ends the body with it; an if ends in both its branches.
void Generator::emit_finish(VertexId id) {
    if (!is_branching(id)) {
        add(Opcode::finish, unused, emit(id));
        return;
    }
    Register positive;
    const std::uint32_t branch = emit_branch(id, positive);
    if (branch == no_jump) {
        add(Opcode::finish, unused, emit_choice(id, positive));
        return;
    }
    const std::size_t mark = trail_.size();
    emit_finish(graph_[id].inputs[1]);
    forget_back_to(mark);
    code_.instructions[branch].data = here();
    emit_finish(graph_[id].inputs[2]);
    forget_back_to(mark);
}

Generator::Register Generator::emit_select(VertexId id) {
    const std::vector<VertexId>& inputs = graph_[id].inputs;
    const auto count = static_cast<std::uint32_t>(inputs.size() - 1);
    const auto table = static_cast<std::uint32_t>(code_.jump_tables.size());
    const Register dst = new_registers();
    add(Opcode::jump_selected, dst, emit(inputs[0]), unused, unused, table);
    code_.jump_tables.resize(table + 1 + count + 2);
    code_.jump_tables[table] = count;
    const std::size_t mark = trail_.size();
    std::vector<std::uint32_t> ends;
    for (std::uint32_t choice = 0; choice < count + 2; ++choice) {
        code_.jump_tables[table + 1 + choice] = here();
        if (choice < 2)
            emit_move(dst, constant(choice == 0 ? 0 : count));
        else
            emit_move(dst, emit(inputs[choice - 1]));
        forget_back_to(mark);
        ends.push_back(add(Opcode::jump, unused));
    }
    for (const std::uint32_t end : ends) code_.instructions[end].data = here();
    return dst;
}

Generator::Register Generator::emit_call(VertexId id) {
    const Vertex& vertex = graph_[id];
    want_instance(vertex.data);
    Register slots = 0;
    for (std::uint32_t i = 0; i < vertex.inputs.size(); ++i)
        slots += analysis_.is_delayed(vertex.data, i) ? 3 : 1;
    const Register block = new_registers(std::max<Register>(1, slots));
    Register slot = block;
    for (std::uint32_t i = 0; i < vertex.inputs.size(); ++i) {
        if (analysis_.is_delayed(vertex.data, i)) {
            emit_delayed(slot, vertex.inputs[i]);
            slot += 3;
        } else {
            emit_move(slot++, emit(vertex.inputs[i]));
        }
    }
    const Register dst = new_registers();
    add(Opcode::call, dst, block, unused, unused, vertex.data);
    return dst;
}

void Generator::emit_delayed(Register slot, VertexId id) {
    int budget = choice_budget;
    if (can_choose(id, budget)) {
        emit_move(slot, emit(id));
        emit_move(slot + 1, constant(0));
        return;
    }
    const std::uint32_t over = add(Opcode::jump, unused);
    const std::uint32_t body = here();
    const std::size_t mark = trail_.size();
    emit_finish(id);
    forget_back_to(mark);
    code_.instructions[over].data = here();
    add(Opcode::delay, slot, unused, unused, unused, body);
}

}  // namespace infra::cal
