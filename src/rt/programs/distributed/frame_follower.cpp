#include "rt/programs/distributed/frame_follower.h"

#include <exception>

#include "common/interrupt.h"
#include "rt/ambient/irradiance_cache.h"
#include "rt/programs/distributed/frame_job.h"
#include "rt/programs/distributed/frame_work.h"
#include "rt/programs/distributed/orders.h"
#include "rt/programs/distributed/traced_pixels.h"
#include "rt/programs/frame_setup.h"
#include "rt/programs/render_frame.h"

namespace infra {
namespace {

void send_report(Team& team, Report report, const std::function<void(MessageWriter&)>& write) {
    MessageWriter out;
    out.put(report);
    write(out);
    team.send(0, out.take());
}

void report_failure(Team& team, Severity severity, const std::string& reason) {
    send_report(team, Report::failure, [&](MessageWriter& out) {
        out.put(severity);
        out.put_text(team.host());
        out.put_text(reason);
    });
}

/// Takes orders while the threads work.
void do_pass(Team& team, FrameWork& work, Pass pass, const Frame& frame) {
    constexpr std::chrono::milliseconds look_around(1);
    TileCrew crew(work.workers, work.painters, pass);
    send_report(team, Report::ready, [&](MessageWriter& out) { out.put(crew.appetite()); });
    for (;;) {
        while (const std::optional<Team::Message> message = team.receive()) {
            MessageReader in(message->bytes);
            if (in.get<Order>() == Order::over) return;
            for (const Tile& tile : in.get_all<Tile>()) crew.give(tile);
        }
        throw_if_interrupted();
        const std::vector<TileResult> results = crew.take(look_around);
        if (results.empty()) continue;
        send_report(team, Report::results, [&](MessageWriter& out) { put_results(out, results, frame); });
    }
}

void do_frame(Team& team, const CompiledScene& scene, const RpictOptions& options, const FrameJob& job,
              Workers& workers, IrradianceCache* cache) {
    const FrameOptions size = frame_options(options, job.width, job.height, job.first_row, cache);
    Camera camera = camera_of(options, job.view, job.previous);
    pass_small_sources(scene, options, size, camera);
    Frame frame = empty_frame(job.width, job.height, job.with_depth, job.with_error, scene.channels());
    FrameWork work(scene, options.render.settings, camera, size, workers, frame);
    for (const Pass pass : passes_of(work.grid, job.width)) {
        Bytes bytes;
        team.broadcast(bytes);
        MessageReader in(bytes);
        take_pixels(in, frame);
        if (pass == Pass::gaps) work.fill_lines();
        do_pass(team, work, pass, frame);
    }
    if (cache) cache->flush();
    send_report(team, Report::done, [&](MessageWriter& out) { put_report(out, work.report()); });
}

}  // namespace

void follow_frames(Team& team, const LoadedScene& loaded, const RpictOptions& options,
                   IrradianceCache* cache) {
    Workers workers(options.threads);
    try {
        for (;;) {
            Bytes bytes;
            team.broadcast(bytes);
            const std::optional<FrameJob> job = unpacked_job(bytes);
            if (!job) return;
            do_frame(team, *loaded.scene, options, *job, workers, cache);
        }
    } catch (const Error& error) {
        report_failure(team, error.severity(), error.what());
        throw;
    } catch (const std::bad_alloc&) {
        report_failure(team, Severity::system, "out of memory");
        throw;
    } catch (const std::exception& error) {
        report_failure(team, Severity::internal, std::string("internal error: ") + error.what());
        throw;
    }
}

}  // namespace infra
