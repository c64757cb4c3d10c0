#include "ir/brdftab/interpolator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.h"
#include "nrlbrdf/half_vector.h"

namespace infra::ir {
namespace {

constexpr double half_pi = std::numbers::pi / 2;

/// Beyond the largest measured angle by more than rounding [rad].
constexpr double angle_slack = 1e-9;

/// The floor under the logarithm, as a share of the median: differences far below the bulk of the data, noise
/// of a detector, do not count.
constexpr double floor_share = 0.01;

/// Samples and incident angles left out to choose the scales, and to report.
constexpr std::size_t choosing = 600;
constexpr std::size_t choosing_angles = 6;
constexpr std::size_t reporting = 2000;
constexpr std::size_t reporting_angles = 30;

/// A lobe varies fastest with theta_h: the other coordinates are mostly shrunk.
constexpr double candidate_scales[] = {0.0625, 0.125, 0.25, 0.5, 1, 2};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double floor_of(const std::vector<BrdfSample>& samples) {
    std::vector<double> positive;
    for (const BrdfSample& s : samples)
        if (s.f > 0) positive.push_back(s.f);
    return positive.empty() ? 1 : floor_share * median(std::move(positive));
}

/// Gathers a CrossValidation prediction by prediction.
class ErrorSums {
  public:
    explicit ErrorSums(double floor) : floor_(floor) {}

    void add(const BrdfSample& sample, double log_predicted) {
        const double error = std::max(0.0, std::exp(log_predicted) - floor_) - sample.f;
        const double log_error = log_predicted - std::log(sample.f + floor_);
        log_squares_ += log_error * log_error;
        squares_ += error * error;
        measured_ += sample.f * sample.f;
        ratios_.push_back(std::abs(error) / (sample.f + floor_));
        if (ratios_.size() == 1 || ratios_.back() > worst_ratio_) {
            worst_ratio_ = ratios_.back();
            worst_ = sample;
        }
    }

    CrossValidation result() const {
        if (ratios_.empty()) return {};
        return {.samples = ratios_.size(),
                .rms_log = std::sqrt(log_squares_ / static_cast<double>(ratios_.size())),
                .median_ratio = median(ratios_),
                .rms_over_rms = measured_ > 0 ? std::sqrt(squares_ / measured_) : 0,
                .worst_ratio = worst_ratio_,
                .worst = worst_};
    }

  private:
    double floor_, log_squares_ = 0, squares_ = 0, measured_ = 0, worst_ratio_ = 0;
    std::vector<double> ratios_;
    BrdfSample worst_;
};

/// Incident angles that were scanned, ascending: those with at least four samples and half as many as the
/// angle that has most. Reciprocals of scans and scattered samples make no scan.
std::vector<double> scanned_angles(const std::vector<BrdfSample>& samples) {
    constexpr std::size_t least_scan = 4;
    std::vector<double> angles;
    std::vector<std::size_t> counts;
    for (const BrdfSample& s : samples) {
        if (angles.empty() || s.theta_i > angles.back() + angle_slack) {
            angles.push_back(s.theta_i);
            counts.push_back(0);
        }
        ++counts.back();
    }
    const std::size_t least = std::max(least_scan, *std::max_element(counts.begin(), counts.end()) / 2);
    std::vector<double> scanned;
    for (std::size_t n = 0; n < angles.size(); ++n)
        if (counts[n] >= least) scanned.push_back(angles[n]);
    return scanned;
}

/// `most` of them, evenly chosen; all when there are fewer.
template <class T>
std::vector<T> thinned(const std::vector<T>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<T> chosen;
    for (std::size_t n = 0; n < most; ++n) chosen.push_back(all[n * all.size() / most]);
    return chosen;
}

Point3 place(double theta_i, double phi, double theta_r, double scale_d, double scale_w) {
    const HalfVector half = half_vector(theta_i, phi, theta_r);
    return {half.theta_h, scale_d * half.theta_d, scale_w * half.cos_imbalance};
}

}  // namespace

SampleInterpolator::SampleInterpolator(std::vector<BrdfSample> samples, Extrapolation extrapolation,
                                       const std::string& name)
    : samples_(std::move(samples)), extrapolation_(extrapolation) {
    if (samples_.size() < least_samples)
        throw Error(Location{name},
                    "only " + std::to_string(samples_.size()) + " different geometries are measured",
                    "at least " + std::to_string(least_samples) + "; for a Lambertian use -lambert");
    floor_ = floor_of(samples_);
    for (const BrdfSample& s : samples_) {
        largest_theta_i_ = std::max(largest_theta_i_, s.theta_i);
        largest_theta_r_ = std::max(largest_theta_r_, s.theta_r);
    }
    choose_scales();
    surface_ = placed(samples_, scale_theta_d_, scale_imbalance_);
}

Shepard SampleInterpolator::placed(const std::vector<BrdfSample>& samples, double scale_d,
                                   double scale_w) const {
    std::vector<Point3> points;
    std::vector<double> values;
    for (const BrdfSample& s : samples) {
        points.push_back(place(s.theta_i, s.phi, s.theta_r, scale_d, scale_w));
        values.push_back(std::log(s.f + floor_));
    }
    return {std::move(points), std::move(values)};
}

CrossValidation SampleInterpolator::without_angles(const std::vector<BrdfSample>& samples,
                                                   const std::vector<double>& angles, double scale_d,
                                                   double scale_w) const {
    ErrorSums sums(floor_);
    for (const double angle : angles) {
        std::vector<BrdfSample> kept, left_out;
        for (const BrdfSample& s : samples) {
            const bool incident = std::abs(s.theta_i - angle) <= angle_slack;
            if (incident) left_out.push_back(s);
            if (!incident && std::abs(s.theta_r - angle) > angle_slack) kept.push_back(s);
        }
        if (kept.size() < least_samples) continue;
        const Shepard others = placed(kept, scale_d, scale_w);
        for (const BrdfSample& s : left_out)
            sums.add(s, others.eval(place(s.theta_i, s.phi, s.theta_r, scale_d, scale_w),
                                    Shepard::Slopes::bounded));
    }
    return sums.result();
}

void SampleInterpolator::choose_scales() {
    const std::vector<BrdfSample> chosen = thinned(samples_, choosing);
    std::vector<double> angles = scanned_angles(chosen);
    if (angles.size() > 2) angles = {angles.begin() + 1, angles.end() - 1};  // between others
    angles = thinned(angles, choosing_angles);
    double least = std::numeric_limits<double>::infinity();
    for (const double scale_d : candidate_scales)
        for (const double scale_w : candidate_scales) {
            const Shepard trial = placed(chosen, scale_d, scale_w);
            ErrorSums sums(floor_);
            for (std::size_t n = 0; n < chosen.size(); ++n) sums.add(chosen[n], trial.predict_without(n));
            const double one = sums.result().rms_log;
            const double angle = without_angles(chosen, angles, scale_d, scale_w).rms_log;
            const double error = one * one + angle * angle;
            if (error < least) {
                least = error;
                scale_theta_d_ = scale_d;
                scale_imbalance_ = scale_w;
            }
        }
}

bool SampleInterpolator::extrapolates(double theta_i, double theta_r) const {
    return theta_i > largest_theta_i_ + angle_slack || theta_r > largest_theta_r_ + angle_slack;
}

double SampleInterpolator::operator()(double theta_i, double phi, double theta_r) const {
    const Point3 at = place(theta_i, phi, theta_r, scale_theta_d_, scale_imbalance_);
    const auto value = [&](Shepard::Slopes slopes) {
        return std::max(0.0, std::exp(surface_->eval(at, slopes)) - floor_);
    };
    if (!extrapolates(theta_i, theta_r)) return value(Shepard::Slopes::bounded);
    if (extrapolation_ == Extrapolation::linear) return value(Shepard::Slopes::open);
    const double held = value(Shepard::Slopes::none);
    if (extrapolation_ == Extrapolation::constant) return held;
    const auto fade = [](double theta, double largest) {
        return theta <= largest ? 1.0 : (half_pi - theta) / (half_pi - largest);
    };
    return held * std::max(0.0, fade(theta_i, largest_theta_i_) * fade(theta_r, largest_theta_r_));
}

CrossValidation SampleInterpolator::leave_one_out() const {
    ErrorSums sums(floor_);
    const std::size_t count = std::min(samples_.size(), reporting);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t n = k * samples_.size() / count;
        sums.add(samples_[n], surface_->predict_without(n));
    }
    return sums.result();
}

CrossValidation SampleInterpolator::leave_angle_out() const {
    const std::vector<BrdfSample> chosen = thinned(samples_, reporting);
    return without_angles(chosen, thinned(scanned_angles(chosen), reporting_angles), scale_theta_d_,
                          scale_imbalance_);
}

}  // namespace infra::ir
