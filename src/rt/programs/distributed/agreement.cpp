#include "rt/programs/distributed/agreement.h"

#include <exception>
#include <string>

#include "common/error.h"

namespace infra {
namespace {

struct Report {
    std::uint64_t result = 0;
    Severity severity{};
    std::string reason;  // of a failure; empty: there was none
};

Report try_step(const std::function<std::uint64_t()>& step) {
    Report report;
    try {
        report.result = step();
    } catch (const Error& error) {
        report.severity = error.severity();
        report.reason = error.what();
    } catch (const std::bad_alloc&) {
        report.severity = Severity::system;
        report.reason = "out of memory";
    } catch (const std::exception& error) {
        report.severity = Severity::internal;
        report.reason = std::string("internal error: ") + error.what();
    }
    return report;
}

/// What rank 0 makes of its own report and those of the others.
Report verdict(Team& team, Report own) {
    for (int others = team.size() - 1; others > 0; --others) {
        const Team::Message message = wait_for_message(team);
        MessageReader in(message.bytes);
        const auto result = in.get<std::uint64_t>();
        const auto severity = in.get<Severity>();
        const std::string reason = in.get_text(), host = in.get_text();
        if (!own.reason.empty()) continue;
        const std::string who = "rank " + std::to_string(message.from) + " on " + host + ": ";
        if (!reason.empty()) {
            own.severity = severity;
            own.reason = who + reason;
        } else if (result != own.result) {
            own.severity = Severity::user;
            own.reason = who + "it has other options or reads other files than rank 0";
        }
    }
    return own;
}

}  // namespace

void take_step(Team& team, const std::function<std::uint64_t()>& step) {
    Report report = try_step(step);
    Bytes bytes;
    if (team.leads()) {
        report = verdict(team, std::move(report));
        bytes.assign(1, report.reason.empty() ? 1 : 0);
    } else {
        MessageWriter out;
        out.put(report.result);
        out.put(report.severity);
        out.put_text(report.reason);
        out.put_text(team.host());
        team.send(0, out.take());
    }
    team.broadcast(bytes);
    const bool agreed = bytes.at(0) == 1;
    if (agreed) return;
    team.part();
    if (!team.leads()) throw Dismissed{};
    throw Error(report.reason, {}, report.severity);
}

}  // namespace infra
