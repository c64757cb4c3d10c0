// Runs compiled code for one evaluation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cal/code.h"
#include "cal/evaluator.h"
#include "cal/host.h"

namespace infra::cal {

/// Calls, cells and delayed values may nest this deep; deeper is taken for endless recursion.
inline constexpr int max_call_depth = 8000;

/// The function that executes an opcode, given which operand (1 to 3) is the last value computed (0: none).
Execute execute_function(Opcode opcode, std::uint8_t last_operand);

/// Whether an instruction computes its register dst, and how many of a, b, c can be the last value computed.
bool gives_value(Opcode opcode);
std::uint8_t operand_count(Opcode opcode);

struct Machine {
    Machine(Evaluator& owner, const Host& world);

    double run_root(const Code::Root& root, std::span<const double> arguments);

    // For the instructions.
    double run_instance(std::uint32_t number, const double* parameters);
    double cell(std::uint32_t number);
    void force(double* slot);
    double real_argument(double number);
    double fault(const char* what);
    double domain_fault(const Instruction& instruction);

    const Code& code;
    const Host& host;
    double* const registers;

  private:
    double run(std::uint32_t entry, double* r);
    double run_deeper(std::uint32_t entry, double* r, const std::string& name);
    double compute_cell(std::uint32_t number);
    double unusual_argument(double number) const;
    [[noreturn]] void too_deep(const std::string& name) const;

    Evaluator& evaluator_;
    double* stack_top_;
    double* const stack_end_;
    int depth_ = 0;
};

inline double Machine::real_argument(double number) {
    const double rounded = number + .5;
    const auto count = static_cast<std::ptrdiff_t>(host.reals.size());  // signed: the faster conversion
    if (rounded >= 1 && rounded < static_cast<double>(count + 1))
        return host.reals[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(rounded) - 1)];
    return unusual_argument(number);
}

inline double Machine::cell(std::uint32_t number) {
    const bool fresh = evaluator_.cell_stamps_[number] == evaluator_.clock_;
    return fresh ? evaluator_.cell_values_[number] : compute_cell(number);
}

}  // namespace infra::cal
