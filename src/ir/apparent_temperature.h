// Radiance pictures as apparent temperatures: those of black surfaces with the same radiance.
#pragma once

#include <string>
#include <vector>

#include "common/pictures/picture.h"
#include "common/planck/planck_scale.h"

namespace infra::ir {

enum class TemperatureUnit { kelvin, celsius };

/// "K" or "degC", as in the header of a picture.
std::string unit_name(TemperatureUnit unit);

/// Radiance to temperature fast enough for every pixel of a picture: cubic interpolation of temperature over
/// the logarithm of radiance, with the exact slope, at temperatures 1 % apart from 1 to 100000 K.
///   accuracy  1e-5 K up to 3000 K
class TemperatureTable {
  public:
    explicit TemperatureTable(const RadianceScale& scale);

    /// Kelvin. NaN for a radiance, in W m^-2 sr^-1, that is not positive, not finite or outside the table.
    double operator()(double radiance) const;

  private:
    struct Node {
        double log_radiance;
        double temperature;
        double slope;  ///< of temperature over log_radiance
    };
    std::vector<Node> nodes_;
};

/// The picture with every channel of every pixel turned into an apparent temperature; NaN where it has none.
/// Lines of the header that tell band, quantity and unit are replaced.
/// throws Error when the header says that the values are something else than radiance.
Picture apparent_temperature(const Picture& picture, const RadianceScale& scale, TemperatureUnit unit);

}  // namespace infra::ir
