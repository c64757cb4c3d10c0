#include "cal/machine.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace infra::cal {
namespace {

/// Name of the function that an opcode is, or a text with blanks.
const char* domain_fault_text(Opcode opcode) {
    switch (opcode) {
        case Opcode::divide:
            return "division by zero";
        case Opcode::power:
            return "illegal power";
        case Opcode::square_root:
            return "sqrt";
        case Opcode::floor:
            return "floor";
        case Opcode::ceiling:
            return "ceil";
        case Opcode::sine:
            return "sin";
        case Opcode::cosine:
            return "cos";
        case Opcode::arc_cosine:
        case Opcode::arc_cosine_clamped:
            return "acos";
        case Opcode::arc_tangent2:
        case Opcode::arc_tangent2_or_zero:
            return "atan2";
        case Opcode::jump_selected:
            return "select";
        default:
            return "domain error";
    }
}

}  // namespace

Machine::Machine(Evaluator& owner, const Host& world)
    : code(owner.program_.code()),
      host(world),
      registers(owner.registers_.data()),
      evaluator_(owner),
      stack_top_(registers + code.static_registers),
      stack_end_(registers + owner.registers_.size()) {}

double Machine::run(std::uint32_t entry, double* r) {
    const Instruction* const first = code.instructions.data() + entry;
    return first->execute(first, r, *this, 0);
}

double Machine::run_root(const Code::Root& root, std::span<const double> arguments) {
    if (!root.is_instance) return run(root.target, registers);
    const InstanceCode& instance = code.instances[root.target];
    if (arguments.size() != instance.delayed.size())
        throw Error(instance.name + "() evaluated with the wrong number of arguments", {},
                    Severity::internal);
    double* const block = stack_top_;
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
    ++evaluator_.fault_count_;
    evaluator_.last_fault_ = what;
    return 0;
}

double Machine::domain_fault(const Instruction& instruction) {
    return fault(domain_fault_text(instruction.opcode));
}

void Machine::too_deep(const std::string& name) const {
    throw host.error("endless recursion" + (name.empty() ? "" : " in " + name + "()"),
                     "calls are " + std::to_string(depth_) + " deep");
}

double Machine::run_deeper(std::uint32_t entry, double* r, const std::string& name) {
    if (++depth_ > max_call_depth) too_deep(name);
    const double value = run(entry, r);
    --depth_;
    return value;
}

double Machine::run_instance(std::uint32_t number, const double* parameters) {
    const InstanceCode& instance = code.instances[number];
    double* const frame = stack_top_;
    if (instance.frame_size > stack_end_ - frame) too_deep(instance.name);
    if (parameters != frame) std::copy_n(parameters, instance.parameter_slots, frame);
    std::copy(instance.constants.begin(), instance.constants.end(), frame + instance.parameter_slots);
    stack_top_ += instance.frame_size;
    const double value = run_deeper(instance.entry, frame, instance.name);
    stack_top_ = frame;
    return value;
}

double Machine::compute_cell(std::uint32_t number) {
    static const std::string no_name;
    const double value = run_deeper(code.cells[number], registers, no_name);
    evaluator_.cell_values_[number] = value;
    evaluator_.cell_stamps_[number] = evaluator_.clock_;
    return value;
}

// A delayed value is three registers: the value, the place of its code (0 once it is computed), and where the
// frame of that code begins.
void Machine::force(double* slot) {
    static const std::string no_name;
    const auto entry = static_cast<std::uint32_t>(slot[1]);
    double* const frame = registers + static_cast<std::size_t>(slot[2]);
    slot[0] = run_deeper(entry, frame, no_name);
    slot[1] = 0;
}

double Machine::unusual_argument(double number) const {
    if (host.reals.empty() && !host.channel && host.owner.empty())
        throw host.error("arg() used in a constant expression", "define it with '=', not ':'");
    const auto count = static_cast<double>(host.reals.size());
    if (number + .5 < 1) return count;
    constexpr double printable = 1e9;
    const std::string which = number < printable ? std::to_string(std::lround(number)) : "of that number";
    throw host.error("missing real argument " + which, "there are " + std::to_string(host.reals.size()));
}

}  // namespace infra::cal
