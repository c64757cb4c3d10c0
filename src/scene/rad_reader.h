// Reader of RADIANCE scene text (.rad) into a Scene: names resolved, commands run.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/warnings.h"

namespace infra {

/// Reads a scene file, a command's output ("!xform -rx 90 x.rad", run by /bin/sh) or the standard input ("")
/// and adds its primitives to `scene`. Commands inside are run in turn. Empty files and failing commands are
/// warned of.
///   throws  Error with file and line for anything malformed, and for files that cannot be opened
void read_rad(Scene& scene, const std::string& spec, const WarningSink& warn);

/// The same for text in memory; `file_name` is for messages.
void read_rad_text(Scene& scene, std::string_view text, const std::string& file_name,
                   const WarningSink& warn);

}  // namespace infra
