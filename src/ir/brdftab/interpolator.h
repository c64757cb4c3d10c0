// A BRDF everywhere from samples anywhere.
//
// Samples are placed by the half vector, (theta_h, a theta_d, b (cos theta_r - cos theta_i)/2): a lobe stays
// at theta_h = 0 while the mirror direction moves with theta_i, so that it is carried from one measured
// incident angle to the next instead of fading out here and in there. Exchanged directions differ only in the
// sign of the third coordinate. There log(f + floor) is interpolated by Shepard's bounded method (shepard.h),
// which keeps f between the values of the neighbouring samples, nowhere negative, and a constant a constant.
// The scales a and b are those with the least cross-validation error, of single samples and of whole incident
// angles left out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ir/brdftab/sample.h"
#include "ir/brdftab/shepard.h"

namespace infra::ir {

/// What is assumed where theta_i or theta_r is beyond the largest measured.
enum class Extrapolation {
    constant,  ///< the blend of the nearest samples' values, without their slopes
    linear,    ///< their slopes go on (in log f), within the range of all samples
    zero       ///< `constant`, fading to 0 at 90 deg
};

/// How well the samples predict one another.
struct CrossValidation {
    std::size_t samples = 0;  ///< left out, one at a time
    double rms_log = 0;       ///< RMS of ln((predicted + floor) / (measured + floor))
    double median_ratio = 0;  ///< median of |predicted - measured| / (measured + floor)
    double rms_over_rms = 0;  ///< RMS of predicted - measured over RMS of measured
    double worst_ratio = 0;   ///< largest of what median_ratio is the median of
    BrdfSample worst;         ///< where
};

class SampleInterpolator {
  public:
    /// samples from distinct_samples(); `name` stands for their file in errors.
    ///   throws  Error when there are fewer than least_samples
    SampleInterpolator(std::vector<BrdfSample> samples, Extrapolation extrapolation, const std::string& name);

    static constexpr std::size_t least_samples = 4;

    /// f [1/sr] >= 0, angles in radians.
    double operator()(double theta_i, double phi, double theta_r) const;

    /// Whether the polar angles are beyond those measured.
    bool extrapolates(double theta_i, double theta_r) const;

    /// Leaves out every sample in turn, or an even choice of 2000 when there are more.
    CrossValidation leave_one_out() const;

    /// Leaves out all samples of an incident angle and their reciprocals, for each angle in turn: what to
    /// expect between the angles measured, and, of the first and the last, beyond them. At most 30 angles and
    /// 2000 samples, evenly chosen. No samples in the result when there is one angle only, or
    /// no scans at an angle.
    CrossValidation leave_angle_out() const;

    const std::vector<BrdfSample>& samples() const { return samples_; }
    double largest_theta_i() const { return largest_theta_i_; }
    double largest_theta_r() const { return largest_theta_r_; }
    double scale_theta_d() const { return scale_theta_d_; }
    double scale_imbalance() const { return scale_imbalance_; }
    double floor() const { return floor_; }

  private:
    Shepard placed(const std::vector<BrdfSample>& samples, double scale_d, double scale_w) const;
    CrossValidation without_angles(const std::vector<BrdfSample>& samples, const std::vector<double>& angles,
                                   double scale_d, double scale_w) const;
    void choose_scales();

    std::vector<BrdfSample> samples_;
    Extrapolation extrapolation_;
    double floor_ = 0;
    double largest_theta_i_ = 0, largest_theta_r_ = 0;
    double scale_theta_d_ = 1, scale_imbalance_ = 1;
    std::optional<Shepard> surface_;  // made once the scales are known
};

}  // namespace infra::ir
