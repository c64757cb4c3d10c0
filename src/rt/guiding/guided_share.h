// The rays of one hemisphere or lobe that go where it is bright, and how they share the work with those that
// do not.
#pragma once

#include "rt/guiding/guide.h"
#include "rt/tracer.h"

namespace infra {

class GuidedShare {
  public:
    /// Decides on -gs rays of this kind for a ray of weight 1, fewer for lighter ones, by chance where that
    /// is no whole number. The tracer must have a guide.
    GuidedShare(Tracer& tracer, const Interaction& at, std::uint16_t kind, double weight);

    int count() const { return count_; }
    /// Direction of ray `index` of them, each from a stratum of its own.
    Vec3 draw(int index) const {
        tracer_.spread_scattering(at_, kind_ | primary_ray, index);
        const double u = (index + tracer_.random().uniform()) / count_;
        return lookout_.sample(u, tracer_.random().uniform());
    }

    /// Density [1/sr] of all rays at wi, times their numbers, the expected number of guided ones: were it the
    /// number that chance has made of it, hits without any would leave all that is bright to the others.
    ///   others  density of the rays that are not guided, times their number
    double total(const Vec3& wi, double others) const { return others + expected_ * lookout_.pdf(wi); }
    /// Factor on a ray that was not guided (balance heuristic).
    double weight_of_others(const Vec3& wi, double others) const {
        const double all = total(wi, others);
        return all > 0 ? others / all : 1.0;
    }

  private:
    Tracer& tracer_;
    const Interaction& at_;
    std::uint16_t kind_;
    Lookout lookout_;
    double expected_;  ///< number of rays
    int count_;
};

}  // namespace infra
