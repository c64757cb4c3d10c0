// What leader and followers say to each other while they work on a frame: each message begins with one of
// these.
#pragma once

#include <cstdint>

#include "rt/programs/distributed/message.h"
#include "rt/programs/distributed/tile_crew.h"
#include "rt/programs/program_setup.h"

namespace infra {

enum class Order : std::uint8_t {
    work,  ///< tiles to do (leader)
    over   ///< the pass has no more of them (leader)
};

enum class Report : std::uint8_t {
    ready,    ///< for a pass: how many tiles are wanted at a time (follower)
    results,  ///< tiles that are done, and their pixels (follower)
    done,     ///< with the frame, and what its tracers say (follower)
    failure   ///< severity and reason: nothing more will come (follower)
};

void put_results(MessageWriter& out, const std::vector<TileResult>& results, const Frame& frame);
/// Adds the pixels to the frame.
std::vector<TileResult> take_results(MessageReader& in, Frame& frame);

void put_report(MessageWriter& out, const TracerReport& report);
TracerReport take_report(MessageReader& in);

}  // namespace infra
