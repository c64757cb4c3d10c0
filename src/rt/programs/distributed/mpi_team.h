// A team whose members are the ranks of an MPI program. Only the main thread calls MPI (MPI_THREAD_FUNNELED),
// and it never waits within MPI, where it would keep a processor busy.
#pragma once

#include <mpi.h>

#include <deque>

#include "rt/programs/distributed/team.h"

namespace infra {

class MpiTeam : public Team {
  public:
    /// Starts MPI. One for the life of the program.
    MpiTeam();
    MpiTeam(const MpiTeam&) = delete;
    MpiTeam& operator=(const MpiTeam&) = delete;

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    int members_here() const override { return members_here_; }
    std::string host() const override;
    void broadcast(Bytes& bytes) override;
    void send(int rank, Bytes bytes) override;
    std::optional<Message> receive() override;
    void part() override;

    bool has_parted() const { return parted_; }
    /// Ends all ranks at once.
    [[noreturn]] void abort(int status) const;

  private:
    struct Outgoing {
        Bytes bytes;
        MPI_Request request;
    };
    void forget_what_is_sent();

    int rank_ = 0, size_ = 1, members_here_ = 1;
    std::deque<Outgoing> outgoing_;
    bool parted_ = false;
};

}  // namespace infra
