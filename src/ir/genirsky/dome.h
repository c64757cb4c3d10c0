// A hemisphere's radiances at the nodes of lib/skyfuncs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace infra::ir {

/// By angle from the pole (zenith or nadir) in steps of 10 deg, row h = 0..9, and azimuth in steps of 18 deg,
/// column r = 0..20, whose last repeats the first. Values in W m^-2 sr^-1.
struct Dome {
    static constexpr std::size_t rows = 10, columns = 21;

    /// 10 values where azimuth makes no difference, else 210, column by column.
    std::vector<double> values;

    bool has_azimuth() const { return values.size() > rows; }
    static double angle_deg(std::size_t row) { return 10.0 * static_cast<double>(row); }
    static double azimuth_deg(std::size_t column) { return 18.0 * static_cast<double>(column); }
    /// The same with 210 values.
    Dome with_azimuth() const;

    /// Makes the pole one direction, as it is: where its values differ by azimuth they become their mean.
    /// returns whether they did
    bool join_pole();
};

/// A value at an angle from the pole, degrees.
struct AngleSample {
    double angle_deg = 0;
    double value = 0;
};

/// The value at an angle: linear between samples, that of the first and the last beyond them.
/// shape: at least one sample, angles increasing.
double at_angle(std::span<const AngleSample> samples, double angle_deg);

/// The ten rows of a dome.
std::vector<double> at_rows(std::span<const AngleSample> samples);

}  // namespace infra::ir
