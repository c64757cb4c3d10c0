// The program rtrace: rays on the standard input, what they see on the standard output.
#pragma once

namespace infra {

/// Body for run_program. throws Error for anything wrong.
int rtrace(int argc, char** argv);

}  // namespace infra
