#include "cal/generator.h"

#include <algorithm>
#include <array>
#include <bit>

#include "cal/machine.h"

namespace infra::cal {
namespace {

constexpr int worth_a_home = 4;   // cost below which a vertex is rather computed again
constexpr int choice_budget = 6;  // cost up to which both branches of an if are computed instead of jumping

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

Generator::Generator(const Lowering& lowered, std::vector<RootSource> roots)
    : lowered_(lowered),
      graph_(lowered.graph()),
      analysis_(lowered),
      roots_(std::move(roots)),
      is_shared_(graph_.size()),
      delayed_vertices_(lowered.instances().size()) {}

Code Generator::generate() {
    while (generate_round()) {
    }
    place_bodies();
    pass_on_last_values();
    code_.stack_registers = stack_registers();
    code_.builtins.assign(graph_.builtins().begin(), graph_.builtins().end());
    code_.errors = lowered_.errors();
    return std::move(code_);
}

/// Returns whether vertices were found that need a home, so that another round is due.
bool Generator::generate_round() {
    code_ = Code{};
    learnt_ = false;
    times_emitted_.assign(graph_.size(), 0);
    available_.assign(graph_.size(), unused);
    cell_index_.clear();
    cell_vertices_.clear();
    constant_index_.clear();
    bodies_.clear();
    wanted_instances_.clear();
    instance_wanted_.assign(lowered_.instances().size(), false);
    code_.instances.resize(lowered_.instances().size());
    for (const RootSource& root : roots_) {
        code_.roots.push_back({root.is_instance, root.is_instance ? want_instance(root.id) : here()});
        if (!root.is_instance) root_or_cell_body(root.id, false);
    }
    std::size_t cell = 0, instance = 0;  // bodies may ask for more while they are generated
    while (cell < cell_vertices_.size() || instance < wanted_instances_.size()) {
        if (cell < cell_vertices_.size()) {
            code_.cells.push_back(here());
            root_or_cell_body(cell_vertices_[cell++], true);
        } else {
            instance_body(wanted_instances_[instance++]);
        }
    }
    return learnt_;
}

std::uint32_t Generator::want_instance(std::uint32_t instance) {
    if (!instance_wanted_[instance]) wanted_instances_.push_back(instance);
    instance_wanted_[instance] = true;
    return instance;
}

void Generator::begin_body(std::uint32_t instance, std::vector<double>& constants) {
    instance_ = instance;
    self_ = no_vertex;
    next_register_ = 0;
    constants_ = &constants;
    delayed_slots_.clear();
}

void Generator::end_body(std::uint32_t begin, bool is_cell) {
    forget_back_to(0);
    bodies_.push_back({begin, here(), instance_, is_cell, next_register_});
}

void Generator::root_or_cell_body(VertexId vertex, bool is_cell) {
    const std::uint32_t begin = here();
    begin_body(no_instance, code_.constants);
    if (is_cell) self_ = vertex;
    emit_finish(vertex);
    end_body(begin, is_cell);
}

void Generator::instance_body(std::uint32_t id) {
    const Instance& source = lowered_.instances()[id];
    InstanceCode& instance = code_.instances[id];
    const std::uint32_t begin = here();
    begin_body(id, instance.constants);
    instance.name = source.name;
    instance.entry = begin;
    for (std::uint32_t i = 0; i < source.parameter_count; ++i) {
        instance.delayed.push_back(analysis_.is_delayed(id, i));
        new_registers(instance.delayed.back() ? 3 : 1);
    }
    instance.parameter_slots = next_register_;
    const std::vector<VertexId> delayed = delayed_vertices_[id];
    std::vector<std::uint32_t> prologue;
    for (const VertexId vertex : delayed) {
        delayed_slots_[vertex] = new_registers(3);
        prologue.push_back(add(Opcode::delay, delayed_slots_[vertex]));
    }
    emit_finish(source.body);
    for (std::size_t i = 0; i < delayed.size(); ++i) {
        forget_back_to(0);
        code_.instructions[prologue[i]].data = here();
        self_ = delayed[i];
        emit_finish(delayed[i]);
    }
    end_body(begin, false);
}

// ---- registers ----

Generator::Register Generator::new_registers(Register count) {
    const Register first = next_register_;
    next_register_ += count;
    return first;
}

Generator::Register Generator::constant(double value) {
    const auto number = static_cast<Register>(constants_->size());
    const auto [found, is_new] =
        constant_index_.try_emplace({constants_, std::bit_cast<std::uint64_t>(value)}, number);
    if (is_new) constants_->push_back(value);
    return constant_flag | found->second;
}

/// Registers of constants one after the other.
Generator::Register Generator::constants(std::initializer_list<double> values) {
    const auto first = static_cast<Register>(constants_->size());
    constants_->insert(constants_->end(), values);
    return constant_flag | first;
}

void Generator::remember(VertexId id, Register reg) {
    if (available_[id] != unused) return;
    available_[id] = reg;
    trail_.push_back(id);
}

void Generator::forget_back_to(std::size_t mark) {
    for (; trail_.size() > mark; trail_.pop_back()) available_[trail_.back()] = unused;
}

std::uint32_t Generator::add(Opcode opcode, Register dst, Register a, Register b, Register c,
                             std::uint32_t data) {
    code_.instructions.push_back({nullptr, opcode, 0, dst, a, b, c, data});
    return here() - 1;
}

void Generator::emit_move(Register dst, Register from) { add(Opcode::move, dst, from); }

void Generator::place(const Body& body, Register base) {
    const bool in_frame = body.instance != no_instance;
    const Register parameters = in_frame ? code_.instances[body.instance].parameter_slots : 0;
    const Register constants =
        in_frame ? static_cast<Register>(code_.instances[body.instance].constants.size()) : 0;
    const auto final_number = [&](Register& reg) {
        if (reg == unused) {
            reg = 0;
        } else if (reg & constant_flag) {
            reg = parameters + (reg & ~constant_flag);
        } else if (!in_frame) {
            reg += base;
        } else if (reg >= parameters) {
            reg += constants;
        }
    };
    for (std::uint32_t i = body.begin; i < body.end; ++i) {
        Instruction& instruction = code_.instructions[i];
        for (Register* reg : {&instruction.dst, &instruction.a, &instruction.b, &instruction.c})
            final_number(*reg);
    }
    if (in_frame) code_.instances[body.instance].frame_size = body.registers + constants;
}

void Generator::place_bodies() {
    const auto roots_base = static_cast<Register>(code_.constants.size());
    Register cells_base = roots_base;
    for (const Body& body : bodies_)
        if (!body.is_cell && body.instance == no_instance)
            cells_base = std::max(cells_base, roots_base + body.registers);
    for (const Body& body : bodies_) {
        place(body, body.is_cell ? cells_base : roots_base);
        if (body.is_cell) cells_base += body.registers;
    }
    code_.static_registers = cells_base;
}

/// Marks operands that are what the instruction before has just computed, and chooses the function that
/// executes each instruction accordingly. A register that code jumps to may have come from elsewhere, so jump
/// targets take no part.
void Generator::pass_on_last_values() {
    std::vector<bool> is_target(code_.instructions.size() + 1);
    for (const Instruction& instruction : code_.instructions) {
        switch (instruction.opcode) {
            case Opcode::jump:
            case Opcode::jump_unless_positive:
            case Opcode::jump_unless_greater:
            case Opcode::delay:
                is_target[instruction.data] = true;
                break;
            case Opcode::jump_selected:
                for (std::uint32_t i = 0; i < code_.jump_tables[instruction.data] + 2; ++i)
                    is_target[code_.jump_tables[instruction.data + 1 + i]] = true;
                break;
            default:
                break;
        }
    }
    for (const Body& body : bodies_) is_target[body.begin] = true;
    for (std::size_t i = 0; i < code_.instructions.size(); ++i) {
        Instruction& instruction = code_.instructions[i];
        if (i > 0 && !is_target[i] && gives_value(code_.instructions[i - 1].opcode)) {
            const Register last = code_.instructions[i - 1].dst;
            const std::array<Register, 3> operands{instruction.a, instruction.b, instruction.c};
            for (std::uint8_t k = operand_count(instruction.opcode); k > 0; --k)
                if (operands[k - 1u] == last) instruction.last_operand = k;
        }
        instruction.execute = execute_function(instruction.opcode, instruction.last_operand);
    }
}

/// Room for the call stack: one frame, or many where instances call instances.
Generator::Register Generator::stack_registers() const {
    constexpr Register recursion_registers = 1 << 17;  // 1 MiB; max_call_depth frames of the usual size
    const auto calls = [](const Instruction& instruction) { return instruction.opcode == Opcode::call; };
    if (std::any_of(code_.instructions.begin(), code_.instructions.end(), calls)) return recursion_registers;
    Register largest = 0;
    for (const InstanceCode& instance : code_.instances) largest = std::max(largest, instance.frame_size);
    return largest;
}

// ---- vertices ----

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

// a*b + c and (1-t)*a + t*b in one instruction, where the parts are not needed by themselves.
Generator::Register Generator::emit_sum(VertexId id) {
    const auto private_product = [this](VertexId input) { return is_private(input, Op::multiply); };
    const VertexId left = graph_[id].inputs[0], right = graph_[id].inputs[1];
    if (left != right && private_product(left) && private_product(right)) {
        const Vertex& complement = graph_[graph_[left].inputs[0]];
        const VertexId t = graph_[right].inputs[0];
        const bool interpolates = complement.op == Op::subtract && complement.inputs[1] == t &&
                                  is_constant(complement.inputs[0], 1);
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

/// Tables are read by arg(n*i + j + 1) and the like: one instruction where the number has at most two
/// variable terms.
bool Generator::emit_affine_argument(VertexId number, Register dst) {
    constexpr int longest = 64;
    if (at_hand(number) || is_shared_[number] || analysis_.depth(number) > longest) return false;
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

// ---- branches ----

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

// ---- calls ----

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
