#include "rt/lobes/bsdf_lobe.h"

#include <algorithm>
#include <cmath>

#include "rt/lobes/ward.h"
#include "rt/ray.h"

namespace infra {

BsdfLobe::BsdfLobe(const Spectrum& lobe_coefficient, const BsdfHit& hit, const ScatterTable& table,
                   double total, double resolution, bool spares_aperture)
    : Lobe(table.sides().transmits ? through_lobe : reflected_lobe, lobe_coefficient),
      hit_(hit),
      table_(table),
      inverse_total_(1 / total),
      resolution_(resolution),
      spares_aperture_(spares_aperture) {
    colored = table.colored();
}

LobeDraw BsdfLobe::sample(RandomStream& random, int index, int count) const {
    const Vec3 in = hit_.jittered_viewer(resolution_);
    const double total = table_.total(in);
    if (total <= same_place) return {};
    double choice = (index + random.uniform()) / count;
    if (hit_.sharpness < 1) choice = 0.5 + std::max(0.0, hit_.sharpness) * (choice - 0.5);
    const double u = random.uniform(), v = random.uniform();
    const Vec3 out = table_.sample(in, choice, u, v);
    if (spares_aperture_ && falls_into_aperture(in, out)) return {};
    last_in_ = in;
    const double weight = total * inverse_total_;
    return {hit_.to_scene(out), weight, -weight};
}

bool BsdfLobe::falls_into_aperture(const Vec3& in, const Vec3& out) const {
    const double dx = in.x + out.x, dy = in.y + out.y;
    return dx * dx + dy * dy <= resolution_;
}

double BsdfLobe::pdf(const Vec3& wi) const {
    const Vec3 out = hit_.to_local(wi);
    if (((out.z > 0) != (hit_.viewer.z > 0)) != table_.sides().transmits) return 0;
    if (spares_aperture_ && falls_into_aperture(hit_.viewer, out)) return 0;
    const double total = table_.total(hit_.viewer);
    return total > same_place ? table_.entry(hit_.viewer, out).value * std::fabs(out.z) / total : 0.0;
}

void BsdfLobe::tint(const Vec3& wi, Spectrum& factor) const {
    const Xyz color = table_.color(last_in_, hit_.to_local(wi));
    factor = color.y > 0 ? hit_.spectrum_of(color * (1 / color.y)) : Spectrum(factor.channels(), 1.0f);
}

int BsdfLobe::sample_count(double ray_weight) const { return ward_sample_count(hit_.sharpness, ray_weight); }

}  // namespace infra
