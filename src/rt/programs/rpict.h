// The program rpict: an octree and a view in, a picture out.
#pragma once

namespace infra {

/// Body for run_program. throws Error for anything wrong; nothing that looks like a picture is left behind
/// then.
int rpict(int argc, char** argv);

}  // namespace infra
