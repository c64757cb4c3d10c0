// The program rcontrib: rays on the standard input, what the surfaces of named modifiers contribute to them
// on the outputs.
#pragma once

namespace infra {

/// Body for run_program. throws Error for anything wrong.
int rcontrib(int argc, char** argv);

}  // namespace infra
