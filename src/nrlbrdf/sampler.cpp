#include "nrlbrdf/sampler.h"

#include <utility>

#include "common/error.h"
#include "nrlbrdf/probe.h"

namespace infra {

LobeSampler::LobeSampler(std::shared_ptr<const TableDistribution> distribution, double alpha)
    : distribution_(std::move(distribution)), alpha_(alpha) {
    if (!(alpha > 0 && alpha <= 1))
        throw Error("nrlbrdf: alpha must be in (0, 1]", "RMS slope of the Gaussian probe");
}

LobeSample LobeSampler::evaluate(const Vec3& wo, const Vec3& wi, double reflectance) const {
    LobeSample result{.wi = wi};
    if (!(reflectance > 0) || wo.z <= 0 || wi.z <= 0) return result;
    const double lobe_cosine = table().eval_lobe(wo, wi) * wi.z;
    result.pdf = (1 - probe_share) * lobe_cosine / reflectance + probe_share * probe_pdf(wo, wi, alpha_);
    if (result.pdf > 0) result.weight = lobe_cosine / result.pdf;
    return result;
}

LobeSample LobeSampler::sample(const Vec3& wo, double u1, double u2, double u3) const {
    const double reflectance = table().lobe_reflectance_dh(wo.z);
    if (wo.z <= 0 || !(reflectance > 0)) return {};
    const Vec3 wi = u1 < probe_share
                        ? sample_probe(wo, alpha_, u2, u3)
                        : distribution_->sample(wo, (u1 - probe_share) / (1 - probe_share), u2, u3);
    return evaluate(wo, wi, reflectance);
}

double LobeSampler::pdf(const Vec3& wo, const Vec3& wi) const {
    return evaluate(wo, wi, table().lobe_reflectance_dh(wo.z)).pdf;
}

}  // namespace infra
