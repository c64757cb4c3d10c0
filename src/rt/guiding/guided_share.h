// The rays of one hemisphere or lobe that go where it is bright, and how they share the work with those that
// do not.
#pragma once

#include "rt/guiding/guide.h"
#include "rt/tracer.h"

namespace infra {

class GuidedShare {
  public:
    /// Decides on -gs rays for a ray of weight 1, fewer for lighter ones, by chance where that is no whole
    /// number. The tracer must have a guide.
    GuidedShare(Tracer& tracer, const Vec3& point, double weight);

    int count() const { return count_; }
    /// Direction of ray `index` of them, each from a stratum of its own.
    Vec3 draw(int index) const {
        const double u = (index + tracer_.random().uniform()) / count_;
        return lookout_.sample(u, tracer_.random().uniform());
    }

    /// Density [1/sr] of all rays at wi, times their numbers; others: that of the rays that are not guided,
    /// times their number.
    double total(const Vec3& wi, double others) const {
        return count_ == 0 ? others : others + count_ * lookout_.pdf(wi);
    }
    /// Factor on a ray that was not guided (balance heuristic).
    double weight_of_others(const Vec3& wi, double others) const {
        if (count_ == 0) return 1.0;
        const double all = total(wi, others);
        return all > 0 ? others / all : 1.0;
    }

  private:
    Tracer& tracer_;
    Lookout lookout_;
    int count_;
};

}  // namespace infra
