// The processes that make a picture together, whatever carries their messages. They are numbered by rank;
// rank 0 leads: it talks to the user, hands out work and writes files.
#pragma once

#include <optional>
#include <string>

#include "rt/programs/distributed/message.h"

namespace infra {

/// As one member sees it. Only the thread that made it may use it.
class Team {
  public:
    struct Message {
        int from;
        Bytes bytes;
    };

    virtual ~Team() = default;

    virtual int rank() const = 0;
    virtual int size() const = 0;
    bool leads() const { return rank() == 0; }
    /// Members on this machine, this one among them.
    virtual int members_here() const = 0;
    /// Name of this machine.
    virtual std::string host() const = 0;

    /// Rank 0's bytes become everybody's. All must call it, and it waits for the others, without work for the
    /// processor.
    virtual void broadcast(Bytes& bytes) = 0;

    /// Messages arrive in the order in which they were sent from the same member. Neither call waits.
    virtual void send(int rank, Bytes bytes) = 0;
    virtual std::optional<Message> receive() = 0;

    /// All are done and part in good order; nothing can be sent afterwards. Waits for the others.
    virtual void part() = 0;
};

/// Waits for a message, without work for the processor.
///   throws  Error "interrupted" after a signal
Team::Message wait_for_message(Team& team);

}  // namespace infra
