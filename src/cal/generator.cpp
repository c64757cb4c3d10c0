#include "cal/generator.h"

#include <algorithm>
#include <array>
#include <bit>

#include "cal/machine.h"

namespace infra::cal {

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
        if (instruction.opcode == Opcode::interpolate_arguments) final_number(instruction.data);
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

}  // namespace infra::cal
