// -r and -ro: a picture that a stopped program left is finished.
#pragma once

#include <optional>
#include <string>

#include "rt/programs/partial_frame.h"
#include "rt/programs/rpict_options.h"
#include "scene/warnings.h"

namespace infra {

struct Recovery {
    PartialFrame partial;
    bool view_found = false;  ///< otherwise the view is the caller's
    std::string path;         ///< the file it came from, which has served when the picture is whole
};

/// Reads what is left of a picture: "name.partial" if there is one, else the file itself, which is of rpict's
/// own kind or any picture in RADIANCE's format, whole or not.
///   options  of the picture to be: what is found must fit them
///   returns  nothing, after a warning, if there is no such file, or an empty one where views come from
///            elsewhere (-S)
///   throws   Error for a file of another kind, a damaged one, or one whose channels are others
std::optional<Recovery> find_unfinished(const std::string& path, const RpictOptions& options,
                                        const Channels& channels, const WarningSink& warn);

}  // namespace infra
