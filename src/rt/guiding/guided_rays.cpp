// How the tracer sends rays where it is bright.
#include <algorithm>
#include <cmath>

#include "rt/guiding/guided_share.h"

namespace infra {

GuidedShare::GuidedShare(Tracer& tracer, const Interaction& at, std::uint16_t kind, double weight)
    : tracer_(tracer), at_(at), kind_(kind), lookout_(*tracer.guide_, at.point) {
    expected_ = std::min<double>(tracer.settings().guided_samples * weight, most_samples);
    const double whole = std::floor(expected_);
    count_ = static_cast<int>(whole) + (tracer.random().uniform() < expected_ - whole ? 1 : 0);
}

bool Tracer::trace_guided(std::uint16_t kind, const Spectrum& coefficient, const Vec3& direction,
                          const Interaction& at, Spectrum& radiance, double sign) {
    constexpr double above = 1.0001;  // of -lw, so that rounding ends no ray that was lucky
    Spectrum share = coefficient;
    const double weight = at.weight * static_cast<double>(coefficient.maximum());
    const double least = settings_.min_weight * above;
    if (settings_.max_reflections > 0 && weight < least) {
        if (random_.uniform() * least >= weight) return false;
        share *= static_cast<float>(least / weight);
    }
    Ray child(at.channels());
    if (!spawn(child, kind, at, &share)) return false;
    if (kind & ambient_rays) child.ambient_level = at.ray->ambient_level + 1;
    child.direction = direction;
    child.sample_weight = sign;
    Interaction seen(child);
    trace(seen);
    radiance = seen.radiance * child.coefficient;
    return true;
}

}  // namespace infra
