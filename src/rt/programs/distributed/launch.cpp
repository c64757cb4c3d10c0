#include "rt/programs/distributed/launch.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

#include "common/error.h"
#include "common/parse_number.h"

namespace infra {
namespace {

std::optional<int> number_in(const char* variable) {
    const char* const text = std::getenv(variable);
    int number = 0;
    if (!text || !parse_int(text, number)) return std::nullopt;
    return number;
}

/// Beside this program.
std::string sibling(const char* name) {
    std::error_code failure;
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", failure);
    return (here.parent_path() / name).string();
}

}  // namespace

std::optional<Launch> find_launch() {
    using Pair = std::pair<const char*, const char*>;
    for (const auto& [rank, size] :
         {Pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), Pair("PMI_RANK", "PMI_SIZE"),
          Pair("PMIX_RANK", "SLURM_STEP_NUM_TASKS")}) {
        const std::optional<int> found = number_in(rank);
        if (!found) continue;
        return Launch{.ranks = number_in(size), .rank = *found};
    }
    return std::nullopt;
}

void join_ranks(char** argv) {
    const std::optional<Launch> launch = find_launch();
    if (!launch) return;
    // Slurm's shells are tasks too.
    if (launch->ranks == 1 && !std::getenv("OMPI_COMM_WORLD_SIZE")) return;
    const std::string program = sibling("rpict-mpi");
    if (access(program.c_str(), X_OK) == 0) {
        execv(program.c_str(), argv);
        throw Error("cannot start \"" + program + "\": " + std::strerror(errno), {}, Severity::system);
    }
    if (launch->ranks.value_or(launch->rank + 1) > 1)
        throw Error("started as one of several ranks, but built without MPI",
                    "each would make the same picture; install Open MPI and build again, or start it alone");
}

}  // namespace infra
