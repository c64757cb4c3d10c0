// A team whose members are threads of one process.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "rt/programs/distributed/team.h"

namespace infra::test {

/// What the members share.
struct Exchange {
    explicit Exchange(int size) : inboxes(size), broadcasts(size) {}

    std::mutex mutex;
    std::condition_variable news;
    std::vector<std::deque<Team::Message>> inboxes;
    std::vector<std::deque<Bytes>> broadcasts;  // by receiver
    int parted = 0;
};

class ThreadTeam : public Team {
  public:
    ThreadTeam(Exchange& exchange, int rank) : exchange_(exchange), rank_(rank) {}

    int rank() const override { return rank_; }
    int size() const override { return static_cast<int>(exchange_.inboxes.size()); }
    int members_here() const override { return size(); }
    std::string host() const override { return "here"; }

    void broadcast(Bytes& bytes) override {
        std::unique_lock lock(exchange_.mutex);
        if (rank_ == 0) {
            for (int other = 1; other < size(); ++other) exchange_.broadcasts[other].push_back(bytes);
            exchange_.news.notify_all();
            return;
        }
        auto& mine = exchange_.broadcasts[rank_];
        exchange_.news.wait(lock, [&] { return !mine.empty(); });
        bytes = std::move(mine.front());
        mine.pop_front();
    }
    void send(int rank, Bytes bytes) override {
        const std::lock_guard lock(exchange_.mutex);
        exchange_.inboxes.at(rank).push_back({rank_, std::move(bytes)});
    }
    std::optional<Message> receive() override {
        const std::lock_guard lock(exchange_.mutex);
        auto& mine = exchange_.inboxes[rank_];
        if (mine.empty()) return std::nullopt;
        Message message = std::move(mine.front());
        mine.pop_front();
        return message;
    }
    void part() override {
        std::unique_lock lock(exchange_.mutex);
        ++exchange_.parted;
        exchange_.news.notify_all();
        exchange_.news.wait(lock, [&] { return exchange_.parted == size(); });
    }

  private:
    Exchange& exchange_;
    const int rank_;
};

/// Runs a body for every rank, rank 0 on this thread, and waits for all.
inline void run_team(int size, const std::function<void(Team&)>& body) {
    Exchange exchange(size);
    std::vector<std::thread> others;
    for (int rank = 1; rank < size; ++rank)
        others.emplace_back([&exchange, &body, rank] {
            ThreadTeam team(exchange, rank);
            body(team);
        });
    ThreadTeam team(exchange, 0);
    body(team);
    for (std::thread& other : others) other.join();
}

}  // namespace infra::test
