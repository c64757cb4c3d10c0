// Measured BRDF samples: a value at a geometry, anywhere, in no order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace infra::ir {

/// One measurement. Angles in radians; phi is the azimuth of the reflected minus that of the incident
/// direction, mirror direction at pi.
struct BrdfSample {
    double theta_i = 0, phi = 0, theta_r = 0;
    double f = 0;  ///< [1/sr], finite and >= 0
    int line = 0;  ///< in its file
};

/// The samples of one file.
struct SampleSet {
    std::vector<BrdfSample> samples;
    std::size_t negatives_zeroed = 0;  ///< values below 0 that were taken for 0, as asked
};

/// How a file is to be understood.
struct SampleRules {
    bool mirror_at_zero = false;    ///< the file's mirror direction is phi = 0, not 180 deg
    bool negative_is_zero = false;  ///< take a negative value for 0 instead of refusing it
};

/// One sample for each geometry, sorted: phi folded into 0..pi (a surface without a direction of its own
/// looks the same from the left and the right), 0 where a direction is the normal; samples of one geometry
/// become their mean.
///   with_reciprocal  each sample stands for its exchanged geometry too
std::vector<BrdfSample> distinct_samples(const std::vector<BrdfSample>& samples, bool with_reciprocal);

}  // namespace infra::ir
