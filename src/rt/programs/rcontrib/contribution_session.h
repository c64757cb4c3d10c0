// Rays in, records out: traces as many rays at a time as are at hand, on all threads, and writes their sums
// in order.
#pragma once

#include <cstdio>

#include "rt/programs/rcontrib/contribution_outputs.h"
#include "rt/programs/rcontrib/contribution_sums.h"

namespace infra {

/// Answers the rays of `input`. Sums do not depend on the number of threads, nor on when rays come.
///   progress_name  program that reports are of (-t)
///   throws         Error when an output fails, an expression cannot be evaluated, or input ends before -y
///   says
void answer_contributions(const ContributionPlan& plan, ContributionOutputs& outputs, std::FILE* input,
                          const std::string& progress_name, const WarningSink& warn);

}  // namespace infra
