// specfunc: multiplies each channel by the mean over its band of a function of wavelength.
//
//     mod specfunc id
//     2+ sfunc funcfile transform
//     0
//     2+ nmA nmB A3 .. An
//
// sfunc(nm) is called at up to 24 wavelengths of nmA..nmB, in either order, as far as the rendering covers
// them; each is drawn at random from the middle nine tenths of its step. source: RADIANCE reference manual,
// "Patterns", and measured.
#include <algorithm>
#include <optional>

#include "common/spectra/resampler.h"
#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"
#include "rt/patterns/constant_spectrum.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr int most_samples = 24;
constexpr int samples_per_channel = 4;  // at most: more would show in no channel
constexpr double jitter = 0.9;

class SpectralFunction final : public Modifier {
  public:
    explicit SpectralFunction(ModifierContext& context)
        : Modifier(context.name(), context.next), function_(context, 1, 0, 1) {
        function_.add_function(context, 0, 1);
        const double nm_a = context.reals()[0], nm_b = context.reals()[1];
        if (!(nm_a > 0) || !(nm_b > 0) || nm_a == nm_b)
            throw context.error("nmA and nmB are not a range of wavelengths",
                                "two wavelengths in nanometres");
        if (!reaches_channels(context, nm_a, nm_b)) return;
        const Channels& channels = context.channels;
        shortest_ = std::max(std::min(nm_a, nm_b), channels.shortest_nm());
        longest_ = std::min(std::max(nm_a, nm_b), channels.longest_nm());
        const double finest =
            (channels.longest_nm() - channels.shortest_nm()) / (samples_per_channel * channels.bands());
        const double step = std::max((longest_ - shortest_) / most_samples, finest);
        count_ = std::max(static_cast<int>((longest_ - shortest_) / step + 0.1), 1);
        resampler_.emplace(channels, static_cast<std::size_t>(count_), shortest_, longest_);
    }

    bool shade(Tracer& tracer, Interaction& at) const override {
        if (!resampler_) return false;
        FunctionCall call(function_, tracer, at);
        const double step = (longest_ - shortest_) / count_;
        double values[most_samples];
        for (int i = 0; i < count_; ++i) {
            const double shift = jitter * (tracer.random().uniform() - 0.5);
            values[i] = call.call(0, shortest_ + (i + 0.5 + shift) * step);
        }
        if (!call.ok()) return false;
        at.pattern *= (*resampler_)(std::span(values).first(static_cast<std::size_t>(count_)));
        return false;
    }

  private:
    FunctionSet function_;
    double shortest_ = 0, longest_ = 0;
    int count_ = 0;
    std::optional<Resampler> resampler_;  ///< none: nothing to do with the channels rendered
};

}  // namespace

std::unique_ptr<Modifier> make_specfunc(ModifierContext& context) {
    return std::make_unique<SpectralFunction>(context);
}

}  // namespace infra
