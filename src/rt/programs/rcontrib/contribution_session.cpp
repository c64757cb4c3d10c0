#include "rt/programs/rcontrib/contribution_session.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "common/error.h"
#include "common/format.h"
#include "common/progress.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/ray_input.h"
#include "rt/programs/workers.h"

namespace infra {
namespace {

/// How far RADIANCE moves the point of -I off the surface it may lie on.
constexpr double irradiance_offset = 1.1e-4;
/// Rays of one record whose sum is taken by itself: fixed, so that rounding does not depend on -n.
constexpr std::size_t rays_a_sum = 32;
/// Rays of a piece where each makes a record.
constexpr std::size_t most_records_a_piece = 8;
/// What a batch of pieces may take for values, in bytes, and the most pieces a thread.
constexpr std::size_t batch_bytes = std::size_t(64) << 20;
constexpr std::size_t most_pieces_a_thread = 256;

/// Another seed for every sum that is gone on with: its noise must not repeat itself.
std::uint64_t seed_after(std::uint64_t seed, std::span<const double> sums) {
    std::uint64_t hash = seed ^ 0x9e3779b97f4a7c15u;
    for (const double value : sums) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
        hash ^= hash >> 29;
    }
    return hash;
}

class ContributionSession {
  public:
    ContributionSession(const ContributionPlan& plan, ContributionOutputs& outputs, std::FILE* input,
                        const std::string& progress_name, const WarningSink& warn)
        : plan_(plan),
          settings_(plan.settings()),
          outputs_(outputs),
          input_(input, settings_.input),
          warn_(warn),
          workers_(settings_.threads),
          record_(plan.value_count(), 0.0),
          texts_(outputs.targets().size()) {
        const std::size_t bytes =
            plan.value_count() * (each_makes_a_record() ? 16 * most_records_a_piece : 8);
        const auto threads = static_cast<std::size_t>(workers_.count());
        pieces_a_batch_ = std::clamp(batch_bytes / std::max<std::size_t>(bytes, 1), threads,
                                     threads * most_pieces_a_thread);
        // A person who types rays wants each one answered.
        if (isatty(fileno(input))) pieces_a_batch_ = records_a_piece_ = 1;
        if (const std::uint64_t limit = settings_.ray_limit(); limit > 0 && settings_.report_seconds > 0)
            progress_.emplace(progress_name, limit, settings_.report_seconds, false);
    }

    void run() {
        std::uint64_t seed = settings_.render.settings.seed;
        if (settings_.recover && settings_.accumulate == 0) {
            if (outputs_.reload(record_, warn_)) seed = seed_after(seed, record_);
        } else if (settings_.recover) {
            const std::uint64_t records = outputs_.resume(warn_);
            if (const std::uint64_t limit = settings_.record_limit(); limit > 0 && records >= limit) {
                warn_("output appears to be complete");
                return;
            }
            skip_rays(records * static_cast<std::uint64_t>(settings_.accumulate));
        }
        for (int i = 0; i < workers_.count(); ++i) {
            tracers_.push_back(std::make_unique<Tracer>(plan_.scene(), settings_.render.settings, seed));
            sums_.push_back(std::make_unique<ContributionSums>(plan_));
            tracers_.back()->set_observer(sums_.back().get(), ShadowRays::arriving);
        }
        bool more = true;
        while (more) {
            more = read_batch();
            trace_batch();
            write_batch();
            if (flush_due_) outputs_.flush();
            flush_due_ = false;
        }
        finish();
    }

  private:
    /// Rays of the batch that one thread takes at a time.
    struct Piece {
        std::size_t begin;
        std::size_t end;
        bool ends_record;                  ///< and its sum is the last of a record
        std::vector<double> sum{};         ///< of several rays of a record
        std::vector<std::string> texts{};  ///< of a record a ray, one a target
    };

    bool each_makes_a_record() const { return settings_.accumulate == 1; }

    void skip_rays(std::uint64_t count) {
        RayRequest ray;
        for (; rays_read_ < count; ++rays_read_)
            if (!input_.next(ray)) throw Error("unexpected EOF on input", "it ends before the files do");
    }

    /// Fills the batch up to the next flush. False at the end of input.
    bool read_batch() {
        rays_.clear();
        pieces_.clear();
        first_ray_ = rays_read_;
        const std::uint64_t limit = settings_.ray_limit();
        const std::size_t most = each_makes_a_record() ? records_a_piece_ : rays_a_sum;
        while (pieces_.size() < pieces_a_batch_) {
            const std::size_t begin = rays_.size();
            bool more = true, ends_record = false;
            while (rays_.size() - begin < most && !ends_record && !flush_due_) {
                if ((limit > 0 && rays_read_ == limit) || !read_ray()) {
                    more = false;
                    break;
                }
                ends_record = note_ray();
            }
            if (rays_.size() > begin) pieces_.push_back({begin, rays_.size(), ends_record});
            if (!more) return false;
            if (flush_due_) return true;
        }
        return true;
    }

    bool read_ray() {
        RayRequest& ray = rays_.emplace_back();
        while (input_.next(ray)) {
            if (ray.length > 0 || settings_.accumulate > 0) {
                ++rays_read_;
                return true;
            }
            if (!dummies_told_) warn_("dummy rays are ignored during accumulation");
            dummies_told_ = true;
        }
        rays_.pop_back();
        return false;
    }

    /// Whether the last ray ends a record of several.
    bool note_ray() {
        const bool is_picture = settings_.height > 0 && settings_.width > 1;
        if (rays_.back().length == 0 && !is_picture) flush_asked_ = true;
        ++rays_in_record_;
        if (settings_.accumulate == 0 || rays_in_record_ < static_cast<std::uint64_t>(settings_.accumulate))
            return false;
        rays_in_record_ = 0;
        ++records_since_flush_;
        const bool interval_over =
            settings_.flush_interval() > 0 && records_since_flush_ >= settings_.flush_interval();
        if (flush_asked_ || interval_over) {
            flush_due_ = true;
            flush_asked_ = false;
            records_since_flush_ = 0;
        }
        return !each_makes_a_record();
    }

    void trace_batch() {
        workers_.run(static_cast<int>(pieces_.size()), [this](int number, int worker) {
            Piece& piece = pieces_[static_cast<std::size_t>(number)];
            Tracer& tracer = *tracers_[static_cast<std::size_t>(worker)];
            ContributionSums& sums = *sums_[static_cast<std::size_t>(worker)];
            const std::uint64_t before = tracer.ray_count();
            if (each_makes_a_record()) piece.texts.resize(texts_.size());
            for (std::size_t i = piece.begin; i < piece.end; ++i) {
                trace(rays_[i], first_ray_ + i, tracer);
                if (!each_makes_a_record()) continue;
                append_record(sums.values(), 1.0, piece.texts);
                sums.clear();
            }
            if (!each_makes_a_record()) {
                piece.sum.assign(sums.values().begin(), sums.values().end());
                sums.clear();
            }
            if (progress_) progress_->add(piece.end - piece.begin, tracer.ray_count() - before);
        });
    }

    void trace(const RayRequest& request, std::uint64_t number, Tracer& tracer) const {
        if (request.length <= 0) return;
        tracer.start_stream(number);
        const bool reversed = settings_.immediate_irradiance;
        const Vec3 origin =
            reversed ? request.origin + request.direction * irradiance_offset : request.origin;
        const Vec3 direction = reversed ? -request.direction : request.direction;
        const double reach = settings_.limit_distance && !reversed ? request.length : 0;
        const Ray ray = tracer.primary(origin, direction, reach);
        Interaction at(ray);
        if (reversed)
            tracer.irradiance(at);
        else
            tracer.trace(at);
    }

    void append_record(std::span<const double> sums, double scale, std::span<std::string> texts) const {
        for (std::size_t t = 0; t < texts.size(); ++t)
            outputs_.format().append(outputs_.targets()[t], sums, scale, texts[t]);
    }

    void write_batch() {
        for (Piece& piece : pieces_) {
            if (each_makes_a_record()) {
                outputs_.write(piece.texts);
                continue;
            }
            for (std::size_t i = 0; i < record_.size(); ++i) record_[i] += piece.sum[i];
            if (piece.ends_record) write_record(1.0 / settings_.accumulate);
        }
    }

    void write_record(double scale) {
        for (std::string& text : texts_) text.clear();
        append_record(record_, scale, texts_);
        outputs_.write(texts_);
        std::ranges::fill(record_, 0.0);
    }

    void finish() {
        if (!input_.fault().empty())
            warn_(formatted("input stops at ray %llu: %s", static_cast<unsigned long long>(rays_read_ + 1),
                            input_.fault().c_str()));
        if (settings_.accumulate == 0) {
            write_record(1.0);
        } else if (rays_in_record_ > 0) {
            warn_("partial accumulation in final record");
            write_record(1.0 / static_cast<double>(rays_in_record_));
        }
        outputs_.close();
        if (progress_) progress_->finish();
        report();
        if (rays_read_ < settings_.ray_limit())
            throw Error("unexpected EOF on input", "-x, -y and -c say how many rays there are to be");
    }

    void report() const {
        TracerReport done;
        for (const auto& tracer : tracers_) done.add(*tracer);
        done.warn_of_faults(warn_);
        done.print_statistics("rcontrib", settings_.render, nullptr);
        std::uint64_t undefined = 0, misplaced = 0;
        const ContributionSums *undefined_one = nullptr, *misplaced_one = nullptr;
        for (const auto& sums : sums_) {
            undefined += sums->fault_count();
            misplaced += sums->misplaced_count();
            if (sums->fault_count() > 0) undefined_one = sums.get();
            if (sums->misplaced_count() > 0) misplaced_one = sums.get();
        }
        if (undefined_one)
            warn_(formatted("%llu functions of bins were undefined and count as 0; one of them: %s",
                            static_cast<unsigned long long>(undefined), undefined_one->last_fault().c_str()));
        if (misplaced_one)
            warn_(formatted(
                "%llu contributions ignored, their bins are not below -bn; one of them: bin %g of '%s'",
                static_cast<unsigned long long>(misplaced), misplaced_one->misplaced_bin(),
                misplaced_one->misplaced_modifier().c_str()));
    }

    const ContributionPlan& plan_;
    const RcontribSettings& settings_;
    ContributionOutputs& outputs_;
    RayInput input_;
    const WarningSink& warn_;
    Workers workers_;
    std::vector<std::unique_ptr<Tracer>> tracers_;         // one a worker
    std::vector<std::unique_ptr<ContributionSums>> sums_;  // one a worker
    std::optional<Progress> progress_;

    std::size_t pieces_a_batch_ = 1;
    std::size_t records_a_piece_ = most_records_a_piece;
    std::vector<RayRequest> rays_;
    std::vector<Piece> pieces_;
    std::uint64_t first_ray_ = 0;  // number of the batch's first ray
    std::uint64_t rays_read_ = 0;
    std::uint64_t rays_in_record_ = 0;
    int records_since_flush_ = 0;
    bool flush_asked_ = false, flush_due_ = false;
    bool dummies_told_ = false;
    std::vector<double> record_;      // sum of the record under way
    std::vector<std::string> texts_;  // its form, one a target
};

}  // namespace

void answer_contributions(const ContributionPlan& plan, ContributionOutputs& outputs, std::FILE* input,
                          const std::string& progress_name, const WarningSink& warn) {
    ContributionSession(plan, outputs, input, progress_name, warn).run();
}

}  // namespace infra
