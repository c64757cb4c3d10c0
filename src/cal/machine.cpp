#include "cal/machine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cal/graph.h"

namespace infra::cal {
namespace {

bool is_finite(double value) { return std::abs(value) <= std::numeric_limits<double>::max(); }

const char* domain_fault_text(Opcode opcode) {
    switch (opcode) {
        case Opcode::divide: return "division by zero";
        case Opcode::power: return "illegal power";
        case Opcode::square_root: return "sqrt(): domain error";
        case Opcode::floor: return "floor(): domain error";
        case Opcode::ceiling: return "ceil(): domain error";
        case Opcode::sine: return "sin(): domain error";
        case Opcode::cosine: return "cos(): domain error";
        case Opcode::arc_cosine: return "acos(): domain error";
        case Opcode::arc_tangent2: return "atan2(): domain error";
        case Opcode::jump_selected: return "select(): domain error";
        default: return "domain error";
    }
}

}  // namespace

Machine::Machine(Evaluator& owner, const Host& world)
    : evaluator(owner),
      code(owner.program_.code()),
      host(world),
      registers(owner.registers_.data()),
      stack_top(registers + code.static_registers),
      stack_end(registers + owner.registers_.size()) {}

double Machine::run_root(const Code::Root& root, std::span<const double> arguments) {
    if (!root.is_instance) return run(root.target, registers);
    const InstanceCode& instance = code.instances[root.target];
    if (arguments.size() != instance.delayed.size())
        throw Error(instance.name + "() evaluated with the wrong number of arguments", {}, Severity::internal);
    double* const block = stack_top;
    if (block + instance.parameter_slots > stack_end) too_deep(instance.name.c_str());
    double* slot = block;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        *slot++ = arguments[i];
        if (instance.delayed[i]) {  // computed already
            *slot++ = 0;
            *slot++ = 0;
        }
    }
    return run_instance(root.target, block);
}

double Machine::fault(const char* what) {
    ++evaluator.fault_count_;
    evaluator.last_fault_ = what;
    return 0;
}

double Machine::domain_fault(const Instruction& instruction) { return fault(domain_fault_text(instruction.opcode)); }

void Machine::too_deep(const char* what) const {
    throw host.error("endless recursion in \"" + std::string(what) + "\"",
                     "calls are " + std::to_string(depth) + " deep");
}

double Machine::run_deeper(std::uint32_t entry, double* r, const char* what) {
    if (++depth > max_call_depth) too_deep(what);
    const double value = run(entry, r);
    --depth;
    return value;
}

double Machine::run_instance(std::uint32_t number, const double* parameters) {
    const InstanceCode& instance = code.instances[number];
    double* const frame = stack_top;
    if (instance.frame_size > stack_end - frame) too_deep(instance.name.c_str());
    std::copy_n(parameters, instance.parameter_slots, frame);
    std::copy(instance.constants.begin(), instance.constants.end(), frame + instance.parameter_slots);
    stack_top += instance.frame_size;
    const double value = run_deeper(instance.entry, frame, instance.name.c_str());
    stack_top = frame;
    return value;
}

double Machine::compute_cell(std::uint32_t number) {
    const double value = run_deeper(code.cells[number], registers, "a variable");
    evaluator.cell_values_[number] = value;
    evaluator.cell_stamps_[number] = evaluator.clock_;
    return value;
}

// A delayed value is three registers: the value, the place of its code (0 once it is computed), and where the frame
// of that code begins.
void Machine::force(double* slot) {
    const auto entry = static_cast<std::uint32_t>(slot[1]);
    double* const frame = registers + static_cast<std::size_t>(slot[2]);
    slot[0] = run_deeper(entry, frame, "an argument");
    slot[1] = 0;
}

void Machine::missing_argument(double number) const {
    const std::string which = is_finite(number) ? std::to_string(std::lround(number)) : "of no number";
    throw host.error("missing real argument " + which,
                     "arg(" + which + ") is asked for, there are " + std::to_string(host.reals.size()));
}

inline double Machine::real_argument(double number) {
    const double rounded = number + .5;
    const auto count = static_cast<double>(host.reals.size());
    if (rounded >= 1 && rounded < count + 1) return host.reals[static_cast<std::size_t>(rounded) - 1];
    if (host.reals.empty() && !host.channel)
        throw host.error("arg() used in a constant expression", "define it with '=', not ':'");
    if (rounded < 1) return count;
    missing_argument(number);
}

double Machine::run(std::uint32_t entry, double* r) {
    const Instruction* const instructions = code.instructions.data();
    const Instruction* next = instructions + entry;
    const auto checked = [this](double value, const Instruction& i) {
        return is_finite(value) ? value : domain_fault(i);
    };
    for (;;) {
        const Instruction& i = *next++;
        switch (i.opcode) {
            case Opcode::move: r[i.dst] = r[i.a]; break;
            case Opcode::channel: r[i.dst] = host.channel_value(static_cast<int>(i.data)); break;
            case Opcode::argument: r[i.dst] = real_argument(r[i.a]); break;
            case Opcode::argument_constant:
                r[i.dst] = i.data < host.reals.size() ? host.reals[i.data] : real_argument(i.data + 1.);
                break;
            case Opcode::negate: r[i.dst] = -r[i.a]; break;
            case Opcode::add: r[i.dst] = r[i.a] + r[i.b]; break;
            case Opcode::subtract: r[i.dst] = r[i.a] - r[i.b]; break;
            case Opcode::multiply: r[i.dst] = r[i.a] * r[i.b]; break;
            case Opcode::divide: r[i.dst] = r[i.b] != 0 ? r[i.a] / r[i.b] : domain_fault(i); break;
            case Opcode::power: r[i.dst] = checked(std::pow(r[i.a], r[i.b]), i); break;
            case Opcode::minimum: r[i.dst] = smaller(r[i.a], r[i.b]); break;
            case Opcode::maximum: r[i.dst] = larger(r[i.a], r[i.b]); break;
            case Opcode::multiply_add: r[i.dst] = r[i.a] * r[i.b] + r[i.c]; break;
            case Opcode::interpolate: r[i.dst] = (1 - r[i.a]) * r[i.b] + r[i.a] * r[i.c]; break;
            case Opcode::square_root: r[i.dst] = checked(std::sqrt(r[i.a]), i); break;
            case Opcode::floor: r[i.dst] = checked(std::floor(r[i.a]), i); break;
            case Opcode::ceiling: r[i.dst] = checked(std::ceil(r[i.a]), i); break;
            case Opcode::sine: r[i.dst] = checked(std::sin(r[i.a]), i); break;
            case Opcode::cosine: r[i.dst] = checked(std::cos(r[i.a]), i); break;
            case Opcode::arc_cosine: r[i.dst] = checked(std::acos(r[i.a]), i); break;
            case Opcode::arc_tangent2: r[i.dst] = checked(std::atan2(r[i.a], r[i.b]), i); break;
            case Opcode::builtin: {
                const Builtin& builtin = code.builtins[i.data];
                const double value = builtin.call(r + i.a, host);
                r[i.dst] = is_finite(value) ? value : fault(builtin.name);
                break;
            }
            case Opcode::choose: r[i.dst] = r[i.a] > 0 ? r[i.b] : r[i.c]; break;
            case Opcode::jump: next = instructions + i.data; break;
            case Opcode::jump_unless_positive:
                if (!(r[i.a] > 0)) next = instructions + i.data;
                break;
            case Opcode::jump_unless_greater:
                if (!(r[i.a] > r[i.b])) next = instructions + i.data;
                break;
            case Opcode::jump_selected: {
                const std::uint32_t* const table = code.jump_tables.data() + i.data;
                const int choice = selected(r[i.a], static_cast<int>(table[0]));
                if (choice < 0) domain_fault(i);
                next = instructions + table[choice + 2];
                break;
            }
            case Opcode::load_cell: {
                const bool fresh = evaluator.cell_stamps_[i.data] == evaluator.clock_;
                r[i.dst] = fresh ? evaluator.cell_values_[i.data] : compute_cell(i.data);
                break;
            }
            case Opcode::call: r[i.dst] = run_instance(i.data, r + i.a); break;
            case Opcode::delay:
                r[i.dst + 1] = i.data;
                r[i.dst + 2] = static_cast<double>(r - registers);
                break;
            case Opcode::force:
                if (r[i.a + 1] != 0) force(r + i.a);
                break;
            case Opcode::finish: return r[i.a];
            case Opcode::fail: throw code.errors[i.data];
        }
    }
}

}  // namespace infra::cal
