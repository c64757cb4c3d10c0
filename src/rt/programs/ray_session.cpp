#include "rt/programs/ray_session.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

#include "common/error.h"
#include "common/format.h"
#include "rt/programs/tree_printer.h"
#include "rt/programs/workers.h"

namespace infra {
namespace {

/// Rays that one thread takes at a time, and that all of them read ahead.
constexpr int rays_a_piece = 32;
constexpr std::size_t pieces_a_thread = 256;

/// How far RADIANCE moves the point of -I off the surface it may lie on.
constexpr double irradiance_offset = 1.1e-4;

class RaySession {
  public:
    RaySession(const CompiledScene& scene, IrradianceCache* cache, const RtraceOptions& options,
               const OutputSpec& spec, std::FILE* input, std::FILE* output)
        : scene_(scene),
          cache_(cache),
          options_(options),
          spec_(spec),
          converter_(options.color, scene.channels()),
          input_(input, options.input),
          output_(output),
          workers_(spec.has_tree() ? 1 : options.threads) {
        for (int i = 0; i < workers_.count(); ++i)
            tracers_.push_back(
                std::make_unique<Tracer>(scene, options.render.settings, options.render.settings.seed));
        for (const auto& tracer : tracers_) tracer->use_irradiance_cache(cache);
        // A person who types rays wants each one answered.
        if (!isatty(fileno(input)))
            batch_size_ = rays_a_piece * pieces_a_thread * static_cast<std::size_t>(workers_.count());
    }

    void run(const WarningSink& warn) {
        const std::uint64_t limit = options_.ray_limit();
        while (limit == 0 || rays_read_ < limit) {
            const bool flush = read_batch();
            if (batch_.empty()) break;
            answer_batch();
            if (flush) std::fflush(output_);
        }
        if (!input_.fault().empty())
            warn(formatted("input stops at ray %llu: %s", static_cast<unsigned long long>(rays_read_ + 1),
                           input_.fault().c_str()));
        if (rays_read_ < limit) warn("unexpected EOF on input");
        if (std::fflush(output_) != 0 || std::ferror(output_)) fail();
        TracerReport report;
        for (const auto& tracer : tracers_) report.add(*tracer);
        report.warn_of_faults(warn);
        report.print_statistics("rtrace", options_.render, cache_);
    }

  private:
    [[noreturn]] static void fail() {
        throw Error(std::string("cannot write output: ") + std::strerror(errno), {}, Severity::system);
    }

    /// Fills batch_ up to the next flush. True if that ended it.
    bool read_batch() {
        const std::uint64_t limit = options_.ray_limit(), interval = options_.flush_interval();
        batch_.clear();
        first_ray_ = rays_read_;
        while (batch_.size() < batch_size_ && (limit == 0 || rays_read_ < limit)) {
            RayRequest& ray = batch_.emplace_back();
            if (!input_.next(ray)) {
                batch_.pop_back();
                return false;
            }
            ++rays_read_;
            const bool asked = ray.length == 0;
            since_flush_ = asked ? 0 : since_flush_ + 1;
            if (asked) return true;
            if (interval > 0 && since_flush_ == interval) {
                since_flush_ = 0;
                return true;
            }
        }
        return false;
    }

    void answer_batch() {
        const std::size_t pieces = (batch_.size() + rays_a_piece - 1) / rays_a_piece;
        if (texts_.size() < pieces) texts_.resize(pieces);
        workers_.run(static_cast<int>(pieces), [this](int piece, int worker) {
            const std::size_t begin = static_cast<std::size_t>(piece) * rays_a_piece;
            const std::size_t end = std::min(begin + rays_a_piece, batch_.size());
            texts_[begin / rays_a_piece].clear();
            for (std::size_t i = begin; i < end; ++i)
                answer(batch_[i], first_ray_ + i, *tracers_[worker], texts_[begin / rays_a_piece]);
        });
        for (std::size_t i = 0; i < pieces; ++i)
            if (std::fwrite(texts_[i].data(), 1, texts_[i].size(), output_) != texts_[i].size()) fail();
    }

    void answer(const RayRequest& request, std::uint64_t number, Tracer& tracer, std::string& text) {
        tracer.start_stream(number);
        const bool reversed = options_.immediate_irradiance && request.length > 0;
        const Vec3 origin =
            reversed ? request.origin + request.direction * irradiance_offset : request.origin;
        const Vec3 direction = reversed ? -request.direction : request.direction;
        const Ray ray =
            tracer.primary(origin, direction, options_.limit_distance && !reversed ? request.length : 0);
        Interaction at(ray);

        std::optional<TreePrinter> tree;
        if (spec_.has_tree()) {
            tree.emplace(scene_, spec_, options_.tree_filter, options_.output, converter_, text);
            tracer.set_observer(&*tree, spec_.trace_sources ? ShadowRays::all : ShadowRays::stopped);
        }
        if (request.length > 0) follow(tracer, at);
        tracer.set_observer(nullptr);
        if (spec_.primary.empty()) return;

        ValueWriter writer(options_.output, converter_, text);
        for (const OutputLetter* letter : spec_.primary) letter->write(scene_, at, writer);
        writer.end_of_ray();
    }

    void follow(Tracer& tracer, Interaction& at) const {
        if (options_.immediate_irradiance)
            tracer.irradiance(at);
        else if (spec_.needs_radiance())
            tracer.trace(at);
        else
            tracer.cast(at);
    }

    const CompiledScene& scene_;
    const IrradianceCache* cache_;
    const RtraceOptions& options_;
    const OutputSpec& spec_;
    const ValueConverter converter_;
    RayInput input_;
    std::FILE* output_;
    Workers workers_;
    std::vector<std::unique_ptr<Tracer>> tracers_;  // one a worker

    std::size_t batch_size_ = 1;
    std::vector<RayRequest> batch_;
    std::vector<std::string> texts_;  // what the pieces of the batch have written
    std::uint64_t first_ray_ = 0;     // number of the batch's first ray
    std::uint64_t rays_read_ = 0;
    std::uint64_t since_flush_ = 0;
};

}  // namespace

void answer_rays(const CompiledScene& scene, IrradianceCache* cache, const RtraceOptions& options,
                 const OutputSpec& spec, std::FILE* input, std::FILE* output, const WarningSink& warn) {
    RaySession(scene, cache, options, spec, input, output).run(warn);
}

}  // namespace infra
