// Runs compiled code for one evaluation.
#pragma once

#include <cstdint>

#include "cal/code.h"
#include "cal/evaluator.h"
#include "cal/host.h"

namespace infra::cal {

/// Calls, cells and delayed values may nest this deep; deeper is taken for endless recursion.
inline constexpr int max_call_depth = 8000;

struct Machine {
    Machine(Evaluator& owner, const Host& world);

    double run_root(const Code::Root& root, std::span<const double> arguments);

  private:
    /// Runs from instruction `entry` to `finish`; `r` is where register numbers count from.
    double run(std::uint32_t entry, double* r);
    double run_instance(std::uint32_t number, const double* parameters);
    double run_deeper(std::uint32_t entry, double* r, const char* what);
    [[gnu::noinline]] double compute_cell(std::uint32_t number);
    [[gnu::noinline]] void force(double* slot);
    [[gnu::noinline]] double fault(const char* what);
    [[gnu::noinline]] double domain_fault(const Instruction& instruction);
    double real_argument(double number);
    [[noreturn, gnu::noinline]] void missing_argument(double number) const;
    [[noreturn, gnu::noinline]] void too_deep(const char* what) const;

    Evaluator& evaluator;
    const Code& code;
    const Host& host;
    double* const registers;
    double* stack_top;
    double* const stack_end;
    int depth = 0;
};

}  // namespace infra::cal
