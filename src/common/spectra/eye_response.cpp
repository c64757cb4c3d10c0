#include "common/spectra/eye_response.h"

#include <array>
#include <cstddef>
#include <span>

#include "common/spectra/eye_tables.h"

namespace infra {
namespace {

using eye_tables::step_nm;

/// Integral of a table, linear between its values, from the first value to each.
template <std::size_t N>
constexpr std::array<double, N> integral(const double (&values)[N]) {
    std::array<double, N> result{};
    for (std::size_t i = 1; i < N; ++i)
        result[i] = result[i - 1] + 0.5 * (values[i - 1] + values[i]) * step_nm;
    return result;
}

struct Curve {
    double first_nm;
    double offset_nm;  ///< added to a wavelength before the table is looked up
    std::span<const double> values, integral;
};

constexpr auto integral_x = integral(eye_tables::observer_x);
constexpr auto integral_y = integral(eye_tables::observer_y);
constexpr auto integral_z = integral(eye_tables::observer_z);
constexpr auto integral_scotopic = integral(eye_tables::scotopic);
constexpr auto integral_melanopic = integral(eye_tables::melanopic);

constexpr Curve curves[] = {
    {eye_tables::observer_first_nm, 1.5, eye_tables::observer_x, integral_x},
    {eye_tables::observer_first_nm, 1.5, eye_tables::observer_y, integral_y},
    {eye_tables::observer_first_nm, 1.5, eye_tables::observer_z, integral_z},
    {eye_tables::rods_first_nm, -0.5, eye_tables::scotopic, integral_scotopic},
    {eye_tables::rods_first_nm, 0.5, eye_tables::melanopic, integral_melanopic},
};

}  // namespace

double response_below(EyeResponse response, double nm) {
    const Curve& curve = curves[static_cast<int>(response)];
    const double at = (nm + curve.offset_nm - curve.first_nm) / step_nm;
    if (!(at > 0)) return 0;
    if (at >= static_cast<double>(curve.values.size() - 1)) return 1;
    const std::size_t i = static_cast<std::size_t>(at);
    const double u = at - static_cast<double>(i);
    const double value =
        curve.values[i] + 0.5 * u * (curve.values[i + 1] - curve.values[i]);  // mean of i..at
    return (curve.integral[i] + value * u * step_nm) / curve.integral.back();
}

}  // namespace infra
