#include "ir/brdftab/radial_scale.h"

#include <algorithm>
#include <cmath>

namespace infra::ir {
namespace {

constexpr double headroom = 1.06;     // between the largest value and the frame
constexpr double log_headroom = 1.5;  // the same on a logarithmic radius
constexpr double least_inset = 0.2;   // decades between the centre and the smallest value
constexpr int most_decades = 4;

/// A step of 1, 2 or 5 times a power of ten that gives two to five rings.
double round_step(double range) {
    const double power = std::pow(10, std::floor(std::log10(range / 2)));
    for (const double digit : {5.0, 2.0})
        if (range / (digit * power) >= 2) return digit * power;
    return power;
}

}  // namespace

RadialScale::RadialScale(double low, double high, bool logarithmic) : logarithmic_(logarithmic && high > 0) {
    if (high <= 0) high = 1;
    if (!logarithmic_) {
        frame_ = high * headroom;
        const double step = round_step(frame_);
        for (int n = 1; n * step <= frame_; ++n) ticks_.push_back(n * step);
        return;
    }
    const double top = std::log10(high * log_headroom);
    const double least = std::floor(std::log10(high) - most_decades);
    const double bottom = low > 0 ? std::max(std::floor(std::log10(low) - least_inset), least) : least;
    centre_ = std::pow(10, bottom);
    frame_ = high * log_headroom;
    for (double exponent = bottom + 1; exponent <= top; ++exponent) ticks_.push_back(std::pow(10, exponent));
}

double RadialScale::share(double f) const {
    if (!logarithmic_) return f / frame_;
    return std::max(0.0, std::log(std::max(f, centre_) / centre_) / std::log(frame_ / centre_));
}

}  // namespace infra::ir
