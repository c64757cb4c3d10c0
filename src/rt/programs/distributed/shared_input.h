// The standard input, which only rank 0 has, for all ranks.
#pragma once

#include "rt/programs/distributed/team.h"

namespace infra {

/// Reads rank 0's standard input to its end, and makes what was in it the standard input of every rank. Returns it.
///   throws  Error when it cannot be read
Bytes share_standard_input(Team& team);

}  // namespace infra
