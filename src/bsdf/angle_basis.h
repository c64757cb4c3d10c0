// Klems' way to divide a hemisphere into patches: rings of polar angle, each cut into equal sectors.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/vec.h"

namespace infra {

struct AngleRing {
    double
        upper_deg;  ///< polar angle where the ring ends; it begins where the one before ends, at first at 0
    int sectors;    ///< the first is centred on azimuth 0
};

class AngleBasis {
  public:
    ///   rings  with rising upper_deg up to 90, sectors >= 1; only the innermost may have a single sector
    AngleBasis(std::string name, std::span<const AngleRing> rings);

    const std::string& name() const { return name_; }
    int patch_count() const { return static_cast<int>(patch_ring_.size()); }

    /// The patch that a direction lies in; -1 outside all of them. d: unit length.
    int patch_of(const Vec3& d) const;

    /// A direction within a patch, uniform in projected solid angle for u and v uniform in 0..1.
    Vec3 direction(int patch, double u, double v) const;

    /// Projected solid angle of a patch [sr], pi for all of them together.
    double projected_solid_angle(int patch) const {
        return rings_[patch_ring_[static_cast<std::size_t>(patch)]].projected_solid_angle;
    }

  private:
    struct Ring {
        double upper_deg;
        int sectors;
        int first_patch;
        double inner_cos2, outer_cos2;  ///< squared cosines of its limits
        double projected_solid_angle;   ///< of one sector
    };

    std::string name_;
    std::vector<Ring> rings_;
    std::vector<std::size_t> patch_ring_;  ///< by patch
};

/// Full, half and quarter basis of LBNL/Klems; nullptr for another name. Case does not matter.
const AngleBasis* standard_angle_basis(std::string_view name);

/// Whether two names are the same but for upper and lower case.
bool same_name(std::string_view a, std::string_view b);

}  // namespace infra
