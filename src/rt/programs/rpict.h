// The program rpict: an octree and a view in, a picture out.
#pragma once

namespace infra {

/// Body for run_program. throws Error for anything wrong; nothing that looks like a picture is left behind
/// then.
int rpict(int argc, char** argv);

class Team;

/// The same as one of a team that makes each picture together. Parts from the team when all is done.
///   throws  Error as above on rank 0; on the others what agreement.h and frame_follower.h say
int rpict(int argc, char** argv, Team& team);

}  // namespace infra
