// Whether mpirun or srun has started this process as one of many.
#pragma once

#include <optional>

namespace infra {

struct Launch {
    std::optional<int> ranks;  ///< how many there are, if it can be told
    int rank = 0;
};

/// What the environment says of it, in the variables that Open MPI, MPICH and their kin, and Slurm with PMIx
/// set. Nothing: this process was started by itself.
std::optional<Launch> find_launch();

/// Where there are ranks, goes on as rpict-mpi, the program beside this one that knows MPI; returns where
/// there are none.
///   throws  Error if there is no such program: each rank would make the whole picture
void join_ranks(char** argv);

}  // namespace infra
