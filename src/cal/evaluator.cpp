#include "cal/evaluator.h"

#include <algorithm>

#include "cal/machine.h"

namespace infra::cal {

Evaluator::Evaluator(Program program) : program_(std::move(program)) {
    const Code& code = program_.code();
    registers_.resize(code.static_registers + code.stack_registers);
    std::copy(code.constants.begin(), code.constants.end(), registers_.begin());
    cell_values_.resize(code.cells.size());
    cell_stamps_.resize(code.cells.size());
}

std::string Evaluator::last_fault() const {
    const std::string fault = last_fault_;
    const bool is_function = !fault.empty() && fault.find(' ') == std::string::npos;
    return is_function ? fault + "(): domain error" : fault;
}

double Evaluator::evaluate(ExprId expression, std::span<const double> arguments, const Host& host) {
    const Code& code = program_.code();
    if (expression.index >= code.roots.size())
        throw Error("expression evaluated with a program that does not hold it", {}, Severity::internal);
    return Machine(*this, host).run_root(code.roots[expression.index], arguments);
}

}  // namespace infra::cal
