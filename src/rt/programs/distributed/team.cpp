#include "rt/programs/distributed/team.h"

#include <chrono>
#include <thread>

#include "common/interrupt.h"

namespace infra {

Team::Message wait_for_message(Team& team) {
    constexpr std::chrono::milliseconds pause(1);
    for (;;) {
        if (std::optional<Team::Message> message = team.receive()) return std::move(*message);
        throw_if_interrupted();
        std::this_thread::sleep_for(pause);
    }
}

}  // namespace infra
