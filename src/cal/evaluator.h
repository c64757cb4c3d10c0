// Evaluates the expressions of a Program. One per thread; evaluation neither allocates nor locks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cal/host.h"
#include "cal/program.h"

namespace infra::cal {

class Evaluator {
  public:
    explicit Evaluator(Program program);

    /// Forgets cached values: call it whenever the ray, the record or the primitive (the host's answers)
    /// changes.
    void next_clock() { ++clock_; }

    /// Value of an expression. A domain error or a division by zero gives 0 and is counted, as in RADIANCE.
    ///   throws  Error for an undefined name, a missing real argument, endless recursion, an unknown channel
    double evaluate(ExprId expression, const Host& host) { return evaluate(expression, {}, host); }

    /// Value of a function compiled with Library::compile_function, called with that many arguments.
    double evaluate(ExprId function, std::span<const double> arguments, const Host& host);

    /// Domain errors since construction, and what the last one was, such as "sqrt(): domain error" ("" if
    /// none).
    std::uint64_t fault_count() const { return fault_count_; }
    std::string last_fault() const;

  private:
    friend struct Machine;

    Program program_;
    std::vector<double> registers_;    ///< constants, then a static region for each body, then the call stack
    std::vector<double> cell_values_;  ///< cached values shared between expressions
    std::vector<std::uint64_t> cell_stamps_;  ///< the clock at which each was computed
    std::uint64_t clock_ = 1;
    std::uint64_t fault_count_ = 0;
    const char* last_fault_ = "";  ///< name of a function, or a text with blanks
};

}  // namespace infra::cal
