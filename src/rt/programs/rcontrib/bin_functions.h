// The expressions of -b and -bn. They stand in a library of their own, apart from the scene's, one for each
// list of parameters (-p).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cal/library.h"
#include "cal/program.h"
#include "rt/programs/rcontrib/settings.h"

namespace infra {

/// How the bin of a modifier is found.
struct BinRule {
    int count = 1;                            ///< bins of the modifier
    int program = -1;                         ///< number of the program, -1: it is always bin 0
    cal::ExprId expression = cal::ExprId{0};  ///< in that program
};

class BinFunctions {
  public:
    /// Compiles what all modifiers need. `settings.apply_overrides()` has been called.
    ///   throws  Error for bad syntax, missing files, a constant bin that is not 0, a bad number of bins
    explicit BinFunctions(const RcontribSettings& settings);

    /// As the modifiers in the settings.
    const std::vector<BinRule>& rules() const { return rules_; }
    const std::vector<cal::Program>& programs() const { return programs_; }

  private:
    std::vector<BinRule> rules_;
    std::vector<cal::Program> programs_;
};

}  // namespace infra
