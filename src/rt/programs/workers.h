// A team of threads that share out numbered pieces of work.
#pragma once

#include <functional>
#include <memory>

namespace infra {

class Workers {
  public:
    /// threads: how many work at once, the caller among them; 0: one for each core.
    explicit Workers(int threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    int count() const { return count_; }

    /// Calls work(piece, worker) for every piece in 0..pieces-1, in any order, and returns when all are done.
    /// Calls that run at once have different workers in 0..count()-1. An exception ends the work and is
    /// passed on; so does a signal, as Error "interrupted".
    void run(int pieces, const std::function<void(int piece, int worker)>& work);

  private:
    struct Arena;
    int count_;
    std::unique_ptr<Arena> arena_;
};

}  // namespace infra
