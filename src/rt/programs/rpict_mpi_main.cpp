// rpict as one of the ranks that mpirun or srun has started; rpict itself goes on as this program there.
#include <chrono>
#include <cstdio>
#include <thread>

#include "common/error.h"
#include "rt/programs/distributed/agreement.h"
#include "rt/programs/distributed/launch.h"
#include "rt/programs/distributed/mpi_team.h"
#include "rt/programs/rpict.h"

namespace infra {
namespace {

/// Ranks that do not know of each other would each make the whole picture.
void check_size(const MpiTeam& team) {
    const std::optional<Launch> launch = find_launch();
    if (team.size() == 1 && launch && launch->ranks.value_or(1) > 1)
        throw Error("the ranks do not find each other: they were started by another MPI than this program's",
                    "use the mpirun of the Open MPI that it was built with, or srun --mpi=pmix");
}

/// Rank 0 says what has happened, and ends this rank.
void wait_for_the_end() {
    constexpr std::chrono::seconds patience(60);
    std::this_thread::sleep_for(patience);
}

int run_rank(int argc, char** argv) {
    MpiTeam team;
    try {
        check_size(team);
        if (!team.leads() && !std::freopen("/dev/null", "w", stdout)) return 1;  // -help once is enough
        return rpict(argc, argv, team);
    } catch (const Dismissed&) {
        return 0;
    } catch (...) {
        const int status = team.leads() ? report_exception("rpict") : 1;
        if (team.has_parted()) return status;
        if (!team.leads()) wait_for_the_end();
        team.abort(status);
    }
}

}  // namespace
}  // namespace infra

int main(int argc, char** argv) { return infra::run_program("rpict", infra::run_rank, argc, argv); }
