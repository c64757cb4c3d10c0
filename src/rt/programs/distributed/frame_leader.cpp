#include "rt/programs/distributed/frame_leader.h"

#include <algorithm>
#include <utility>

#include "common/interrupt.h"
#include "rt/programs/distributed/traced_pixels.h"
#include "rt/programs/render_frame.h"

namespace infra {
namespace {

/// Tiles for each thread of the team where lines can be cut: as few as leave nobody idle for long at the end.
constexpr std::size_t tiles_a_thread = 16;

/// While nothing comes from this rank's own threads.
constexpr std::chrono::milliseconds look_around(1);

[[noreturn]] void throw_failure(MessageReader& in, int rank) {
    const auto severity = in.get<Severity>();
    const std::string host = in.get_text(), reason = in.get_text();
    throw Error("rank " + std::to_string(rank) + " on " + host + ": " + reason, {}, severity);
}

}  // namespace

/// One pass over the frame, shared out among the ranks.
class FrameLeader::PassWork {
  public:
    /// early: where messages go that are for later
    PassWork(Team& team, FrameWork& work, Pass pass, Frame& frame, Progress& progress,
             std::deque<Team::Message>& early)
        : team_(team),
          early_(early),
          grid_(work.grid),
          pass_(pass),
          frame_(frame),
          progress_(progress),
          members_(static_cast<std::size_t>(team.size())),
          crew_(work.workers, work.painters, pass) {
        const auto threads = static_cast<std::size_t>(work.workers.count()) * members_.size();
        for (const Tile& tile : tiles_of(grid_, pass, tiles_a_thread * threads)) {
            if (is_known(tile))
                progress_.add(pixels_of(tile, grid_, pass_, frame_.picture.width), 0);
            else
                open_.push_back(tile);
        }
        unfinished_ = open_.size();
        members_[0].appetite = crew_.appetite();
        feed(0);
    }

    bool is_over() const {
        return unfinished_ == 0 && std::all_of(members_.begin() + 1, members_.end(),
                                               [](const Member& member) { return member.is_told; });
    }

    /// Deals with what has come in, waits a moment if that is nothing.
    void look() {
        std::chrono::milliseconds patience = look_around;
        while (std::optional<Team::Message> message = team_.receive()) {
            hear(*message);
            patience = {};
        }
        count(0, crew_.take(patience));
        feed(0);
    }

    /// Numbers of the pixels that were traced in this pass, wherever that was.
    const std::vector<std::uint64_t>& traced() const { return traced_; }

  private:
    struct Member {
        int appetite = 0;  // tiles it wants at a time; 0: it has not said so yet
        int held = 0;
        bool is_told = false;  // that the pass is over
    };

    /// In Pass::samples; which pixels other passes trace is not known before.
    bool is_known(const Tile& tile) const {
        if (pass_ != Pass::samples) return false;
        const std::size_t row = static_cast<std::size_t>(grid_.rows()[tile.line]) * frame_.picture.width;
        const int* const columns = grid_.columns(tile.line).data();
        return std::all_of(columns + tile.begin, columns + tile.end, [&](int column) {
            return frame_.is_traced(row + static_cast<std::size_t>(column));
        });
    }

    void hear(Team::Message& message) {
        const int from = message.from;
        MessageReader in(message.bytes);
        switch (in.get<Report>()) {
            case Report::ready:
                members_[from].appetite = in.get<int>();
                break;
            case Report::results:
                count(from, take_results(in, frame_));
                break;
            case Report::failure:
                throw_failure(in, from);
            case Report::done:
                early_.push_back(std::move(message));
                return;
        }
        feed(from);
    }

    void count(int rank, const std::vector<TileResult>& results) {
        for (const TileResult& result : results) {
            progress_.add(pixels_of(result.tile, grid_, pass_, frame_.picture.width), result.rays);
            traced_.insert(traced_.end(), result.traced.begin(), result.traced.end());
            --members_[rank].held;
            --unfinished_;
        }
    }

    /// As many tiles as a member wants, or word that there are no more.
    void feed(int rank) {
        Member& member = members_[rank];
        std::vector<Tile> portion;
        for (; member.held < member.appetite && !open_.empty(); ++member.held) {
            portion.push_back(open_.front());
            open_.pop_front();
        }
        if (rank == 0) {
            for (const Tile& tile : portion) crew_.give(tile);
            return;
        }
        const bool is_over =
            member.appetite > 0 && member.held == 0 && open_.empty() && !std::exchange(member.is_told, true);
        if (portion.empty() && !is_over) return;
        MessageWriter out;
        out.put(is_over ? Order::over : Order::work);
        if (!is_over) out.put_all(std::span<const Tile>(portion));
        team_.send(rank, out.take());
    }

    Team& team_;
    std::deque<Team::Message>& early_;
    const SampleGrid& grid_;
    const Pass pass_;
    Frame& frame_;
    Progress& progress_;
    std::deque<Tile> open_;  // tiles that nobody has begun
    std::size_t unfinished_ = 0;
    std::vector<Member> members_;
    std::vector<std::uint64_t> traced_;
    TileCrew crew_;
};

void FrameLeader::share(const Frame& frame, const std::vector<std::uint64_t>& pixels) {
    if (team_.size() == 1) return;
    MessageWriter out;
    put_pixels(out, frame, pixels);
    Bytes bytes = out.take();
    team_.broadcast(bytes);
}

void FrameLeader::wait_until_done(TracerReport& report) {
    for (int others = team_.size() - 1; others > 0; --others) {
        const Team::Message message = early_.empty() ? wait_for_message(team_) : std::move(early_.front());
        if (!early_.empty()) early_.pop_front();
        MessageReader in(message.bytes);
        const auto sort = in.get<Report>();
        if (sort == Report::failure) throw_failure(in, message.from);
        if (sort != Report::done) throw Error("a rank has not ended", {}, Severity::internal);
        report.add(take_report(in));
    }
}

void FrameLeader::render(const CompiledScene& scene, const RenderSettings& settings, const Camera& camera,
                         const FrameOptions& options, Workers& workers, Progress& progress, Frame& frame,
                         Checkpoint& checkpoint, TracerReport& report) {
    if (options.first_row >= options.height) return;
    checkpoint.write();
    const FrameJob job{.view = camera.view,
                       .previous = camera.previous,
                       .width = options.width,
                       .height = options.height,
                       .first_row = options.first_row,
                       .with_depth = !frame.depth.empty(),
                       .with_error = !frame.error.empty()};
    idle_ = false;
    Bytes bytes = packed(&job);
    team_.broadcast(bytes);
    FrameWork work(scene, settings, camera, options, workers, frame);
    try {
        do_passes(work, progress, frame, checkpoint);
        wait_until_done(report);
    } catch (...) {
        checkpoint.write_if_possible();
        throw;
    }
    idle_ = true;
    report.add(work.report());
    Progress silent(std::string(), 0, 0, false);
    render_frame(scene, settings, camera, options, workers, silent, frame, nullptr, report);
}

void FrameLeader::do_passes(FrameWork& work, Progress& progress, Frame& frame, Checkpoint& checkpoint) {
    std::vector<std::uint64_t> news = traced_pixels(frame);
    for (const Pass pass : passes_of(work.grid, frame.picture.width)) {
        share(frame, news);
        if (pass == Pass::gaps) work.fill_lines();
        PassWork pass_work(team_, work, pass, frame, progress, early_);
        while (!pass_work.is_over()) {
            pass_work.look();
            if (interrupted()) checkpoint.write_if_possible();  // at once: who sent the signal may not wait
            throw_if_interrupted();
            checkpoint.write_if_due();
        }
        news = pass_work.traced();
    }
}

void FrameLeader::dismiss() {
    Bytes bytes = packed(nullptr);
    team_.broadcast(bytes);
}

}  // namespace infra
