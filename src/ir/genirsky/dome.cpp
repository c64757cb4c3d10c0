#include "ir/genirsky/dome.h"

#include <algorithm>

namespace infra::ir {

Dome Dome::with_azimuth() const {
    if (has_azimuth()) return *this;
    Dome dome;
    for (std::size_t column = 0; column < columns; ++column)
        dome.values.insert(dome.values.end(), values.begin(), values.end());
    return dome;
}

bool Dome::join_pole() {
    double sum = 0;
    bool differ = false;
    for (std::size_t column = 0; has_azimuth() && column + 1 < columns; ++column) {
        sum += values[rows * column];
        differ = differ || values[rows * column] != values[0];
    }
    if (!differ) return false;
    for (std::size_t column = 0; column < columns; ++column)
        values[rows * column] = sum / (static_cast<double>(columns) - 1);
    return true;
}

double at_angle(std::span<const AngleSample> samples, double angle_deg) {
    const auto after = std::ranges::upper_bound(samples, angle_deg, {}, &AngleSample::angle_deg);
    if (after == samples.begin()) return samples.front().value;
    if (after == samples.end()) return samples.back().value;
    const auto before = after - 1;
    const double part = (angle_deg - before->angle_deg) / (after->angle_deg - before->angle_deg);
    return before->value + part * (after->value - before->value);
}

std::vector<double> at_rows(std::span<const AngleSample> samples) {
    std::vector<double> values;
    for (std::size_t row = 0; row < Dome::rows; ++row)
        values.push_back(at_angle(samples, Dome::angle_deg(row)));
    return values;
}

}  // namespace infra::ir
