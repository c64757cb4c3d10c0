// Skies and seas given as values: ten by elevation, 210 in all directions, ThRend's line of ten.
#pragma once

#include "ir/genirsky/dome.h"
#include "ir/genirsky/passband.h"
#include "ir/genirsky/placed_numbers.h"

namespace infra::ir {

/// What a file's numbers are.
enum class ValueUnit {
    radiance,  ///< W m^-2 sr^-1
    kelvin,    ///< temperatures of black bodies
    celsius
};

/// Turns a file's numbers into radiances.
class ValueReader {
  public:
    /// `passband` may be null for radiances. Temperatures that no sky or sea has are added to `odd`, a line
    /// of warning each, where it is given.
    ValueReader(ValueUnit unit, const Passband* passband, std::vector<std::string>* odd = nullptr)
        : unit_(unit), passband_(passband), odd_(odd) {}
    /// throws Error with the place for a temperature not above 0 K and a negative radiance
    double radiance(const PlacedNumber& number, const NumberText& text) const;

  private:
    ValueUnit unit_;
    const Passband* passband_;
    std::vector<std::string>* odd_;
};

/// What is odd about a temperature of a sky, a sea or air, in kelvin: "below 100 K", "above 400 K" or "".
std::string oddity(double kelvin);

/// Ten values for angles 0, 10 .. 90 deg from the pole, or lines of an angle and a value.
///   from_horizon  the ten begin at the horizon
///   throws        Error with line and column for another number of values, angles that don't increase or lie
///                 outside 0..90 deg, and as ValueReader
Dome parse_elevations(const NumberText& text, const ValueReader& reader, bool from_horizon);

/// 21 times ten values, or 20 times ten whose first ten then close the circle.
/// throws Error as above, and where the 21st ten differ from the first
Dome parse_dome_table(const NumberText& text, const ValueReader& reader);

/// ThRend's sky: one line of ten.
Dome parse_thrend(const NumberText& text, const ValueReader& reader, bool from_horizon);

}  // namespace infra::ir
