// What rank 0 tells the others of a picture that all are to work on.
#pragma once

#include <optional>

#include "common/views/view.h"
#include "rt/programs/distributed/message.h"

namespace infra {

struct FrameJob {
    View view;                     ///< set up
    std::optional<View> previous;  ///< of the picture before, set up
    int width = 0, height = 0;
    int first_row = 0;  ///< rows above it are known
    bool with_depth = false, with_error = false;
};

/// nullptr: there is nothing more to do.
Bytes packed(const FrameJob* job);
/// Nothing: there is nothing more to do.
std::optional<FrameJob> unpacked_job(const Bytes& bytes);

}  // namespace infra
