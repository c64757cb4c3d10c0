#include "common/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

#include "common/error.h"

namespace infra {
namespace {

/// SIGALRM tells that the first of the others has had no answer in time.
constexpr std::array<int, 4> handled{SIGINT, SIGTERM, SIGHUP, SIGALRM};

/// A path that the signal handler may read at any moment: written first, then published by `state`.
struct Slot {
    enum State { unused, claimed, published };
    std::atomic<int> state{unused};
    char path[PATH_MAX] = {};
};

// A signal handler has no argument of ours, so its state cannot live anywhere else.
std::atomic<int> first_signal{0};  // 0: none yet
std::atomic<unsigned> seconds_to_answer{0};
std::array<Slot, 16> slots;
std::array<struct sigaction, handled.size()> earlier_actions;

static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int signal_number) {
    int seen = 0;
    if (signal_number != SIGALRM && first_signal.compare_exchange_strong(seen, signal_number)) {
        alarm(seconds_to_answer);
        return;
    }
    if (signal_number == SIGALRM && first_signal != 0) signal_number = first_signal;
    for (const Slot& slot : slots)
        if (slot.state.load() == Slot::published) unlink(slot.path);
    signal(signal_number, SIG_DFL);
    raise(signal_number);  // delivered when this handler returns
}

}  // namespace

bool interrupted() { return first_signal.load(std::memory_order_relaxed) != 0; }

void throw_if_interrupted() {
    if (interrupted()) throw Error("interrupted", {}, Severity::internal);
}

void ending_in_order() { alarm(0); }

InterruptGuard::InterruptGuard(unsigned seconds) {
    first_signal = 0;
    seconds_to_answer = seconds;
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < handled.size(); ++i) {
        sigaction(handled[i], nullptr, &earlier_actions[i]);
        if (earlier_actions[i].sa_handler != SIG_IGN) sigaction(handled[i], &action, nullptr);
    }
}

InterruptGuard::~InterruptGuard() {
    alarm(0);
    for (std::size_t i = 0; i < handled.size(); ++i) sigaction(handled[i], &earlier_actions[i], nullptr);
    first_signal = 0;
}

void remove_on_interrupt(const char* path) {
    if (std::strlen(path) >= PATH_MAX) return;
    for (Slot& slot : slots) {
        int expected = Slot::unused;
        if (!slot.state.compare_exchange_strong(expected, Slot::claimed)) continue;
        std::strcpy(slot.path, path);
        slot.state = Slot::published;
        return;
    }
}

void forget_on_interrupt(const char* path) {
    for (Slot& slot : slots) {
        int expected = Slot::published;
        if (slot.state == Slot::published && std::strcmp(slot.path, path) == 0 &&
            slot.state.compare_exchange_strong(expected, Slot::unused))
            return;
    }
}

}  // namespace infra
