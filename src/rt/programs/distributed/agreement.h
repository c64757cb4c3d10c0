// Steps that all ranks take alike, such as reading the scene: if one fails anywhere, all end together, and
// one message says why.
#pragma once

#include <cstdint>
#include <functional>

#include "rt/programs/distributed/team.h"

namespace infra {

/// Ends a rank that has nothing to say: rank 0 tells the user.
struct Dismissed {};

/// Does a step on every rank, and compares what it returns.
///   throws  once any rank has failed, or returned something else than rank 0, and the team has parted: Error
///           with the reason on rank 0, Dismissed on the others
void take_step(Team& team, const std::function<std::uint64_t()>& step);

}  // namespace infra
