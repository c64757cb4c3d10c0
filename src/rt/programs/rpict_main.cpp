#include "common/error.h"
#include "rt/programs/distributed/launch.h"
#include "rt/programs/rpict.h"

namespace {

int run(int argc, char** argv) {
    infra::join_ranks(argv);
    return infra::rpict(argc, argv);
}

}  // namespace

int main(int argc, char** argv) { return infra::run_program("rpict", run, argc, argv); }
