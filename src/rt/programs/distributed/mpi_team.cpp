#include "rt/programs/distributed/mpi_team.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "common/interrupt.h"

namespace infra {
namespace {

constexpr int tag = 0;
/// MPI counts in int.
constexpr std::size_t most_at_once = std::size_t(1) << 30;

/// Waits for one request without work for the processor.
void wait_for(MPI_Request& request) {
    constexpr std::chrono::microseconds pause(500);
    for (int done = 0;;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done) return;
        throw_if_interrupted();
        std::this_thread::sleep_for(pause);
    }
}

void broadcast_part(void* data, std::size_t size) {
    MPI_Request request{};
    MPI_Ibcast(data, static_cast<int>(size), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
    wait_for(request);
}

}  // namespace

MpiTeam::MpiTeam() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm here{};
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
    MPI_Comm_size(here, &members_here_);
    MPI_Comm_free(&here);
}

std::string MpiTeam::host() const {
    std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
    int length = 0;
    MPI_Get_processor_name(name.data(), &length);
    return {name.data(), static_cast<std::size_t>(length)};
}

void MpiTeam::broadcast(Bytes& bytes) {
    std::uint64_t size = bytes.size();
    broadcast_part(&size, sizeof size);
    bytes.resize(size);
    for (std::size_t done = 0; done < size; done += most_at_once)
        broadcast_part(bytes.data() + done, std::min<std::size_t>(most_at_once, size - done));
}

void MpiTeam::send(int rank, Bytes bytes) {
    if (bytes.size() > most_at_once) throw Error("a message is too long", {}, Severity::internal);
    outgoing_.push_back({std::move(bytes), MPI_REQUEST_NULL});
    Outgoing& last = outgoing_.back();
    MPI_Isend(last.bytes.data(), static_cast<int>(last.bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD,
              &last.request);
    forget_what_is_sent();
}

void MpiTeam::forget_what_is_sent() {
    std::erase_if(outgoing_, [](Outgoing& message) {
        int done = 0;
        MPI_Test(&message.request, &done, MPI_STATUS_IGNORE);
        return done != 0;
    });
}

std::optional<Team::Message> MpiTeam::receive() {
    forget_what_is_sent();
    int found = 0;
    MPI_Status status{};
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &found, &status);
    if (!found) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{.from = status.MPI_SOURCE, .bytes = Bytes(static_cast<std::size_t>(size))};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

void MpiTeam::part() {
    for (Outgoing& message : outgoing_) wait_for(message.request);
    outgoing_.clear();
    MPI_Request request{};
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    wait_for(request);
    MPI_Finalize();
    parted_ = true;
}

void MpiTeam::abort(int status) const {
    MPI_Abort(MPI_COMM_WORLD, status);
    std::_Exit(status);
}

}  // namespace infra
