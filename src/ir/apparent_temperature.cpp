#include "ir/apparent_temperature.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.h"

namespace infra::ir {
namespace {

constexpr double no_temperature = std::numeric_limits<double>::quiet_NaN();
constexpr double ice_point = 273.15;  // K

void describe_values(PictureHeader& header, const RadianceScale& scale, TemperatureUnit unit) {
    std::erase_if(header.lines, [](const std::string& line) {
        return line.starts_with("BAND=") || line.starts_with("QUANTITY=") || line.starts_with("UNIT=");
    });
    header.add("BAND= " + scale.description());
    header.add("QUANTITY= apparent temperature");
    header.add("UNIT= " + unit_name(unit));
}

}  // namespace

std::string unit_name(TemperatureUnit unit) { return unit == TemperatureUnit::kelvin ? "K" : "degC"; }

TemperatureTable::TemperatureTable(const RadianceScale& scale) {
    constexpr double ratio = 1.01;
    constexpr double least_radiance = 1e-300;  // below it doubles lose digits
    for (double temperature = coldest_temperature; temperature < hottest_temperature * ratio;
         temperature *= ratio) {
        const ThermalRadiance at = scale.at(temperature);
        if (at.radiance < least_radiance) continue;
        nodes_.push_back({std::log(at.radiance), temperature, at.radiance / at.slope});
    }
}

double TemperatureTable::operator()(double radiance) const {
    if (!(radiance > 0)) return no_temperature;
    const double place = std::log(radiance);
    const auto above = std::ranges::upper_bound(nodes_, place, {}, &Node::log_radiance);
    if (above == nodes_.begin() || above == nodes_.end()) return no_temperature;
    const Node& a = above[-1];
    const Node& b = above[0];
    const double step = b.log_radiance - a.log_radiance;
    const double t = (place - a.log_radiance) / step, s = 1 - t;
    return s * s * ((1 + 2 * t) * a.temperature + t * step * a.slope) +
           t * t * ((1 + 2 * s) * b.temperature - s * step * b.slope);  // Hermite
}

Picture apparent_temperature(const Picture& picture, const RadianceScale& scale, TemperatureUnit unit) {
    const std::string quantity = picture.header.value("QUANTITY").value_or("radiance");
    if (quantity != "radiance")
        throw Error("the picture holds " + quantity + ", not radiance", "-K and -C need radiance");
    const TemperatureTable table(scale);
    const double zero = unit == TemperatureUnit::celsius ? ice_point : 0.0;
    Picture result = picture;
    for (float& value : result.pixels) value = static_cast<float>(table(value) - zero);
    describe_values(result.header, scale, unit);
    return result;
}

}  // namespace infra::ir
