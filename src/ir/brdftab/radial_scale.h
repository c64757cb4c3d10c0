// The radius of a polar diagram: where a value lies between centre and frame, and which values get a ring.
#pragma once

#include <vector>

namespace infra::ir {

class RadialScale {
  public:
    /// For values low..high, 0 <= low <= high. Linear from 0, or logarithmic over at most four decades; all
    /// zero is drawn on 0..1.
    RadialScale(double low, double high, bool logarithmic);

    /// 0 at the centre to 1 at the frame.
    double share(double f) const;

    /// The value at the centre.
    double centre() const { return centre_; }

    /// Values of the rings, round numbers, ascending; not that of the centre.
    const std::vector<double>& ticks() const { return ticks_; }

  private:
    double centre_ = 0, frame_ = 1;
    bool logarithmic_;
    std::vector<double> ticks_;
};

}  // namespace infra::ir
