// What the ranks but 0 do: they wait for frames, do the tiles that they are given, and send back what they
// have traced.
#pragma once

#include "rt/programs/distributed/team.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/rpict_options.h"

namespace infra {

/// Works until rank 0 has nothing more to do.
///   cache   of diffuse interreflection, this rank's own; nullptr: none
///   throws  Error if something fails; rank 0 knows of it then
void follow_frames(Team& team, const LoadedScene& loaded, const RpictOptions& options,
                   IrradianceCache* cache);

}  // namespace infra
