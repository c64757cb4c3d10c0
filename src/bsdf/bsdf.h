// A bidirectional scattering distribution function from an XML file: Klems matrices or tensor trees, as
// genBSDF, WINDOW and RADIANCE's own tools write them. Read once, then immutable and shared by threads.
//
// Directions are in the BSDF's coordinates: x to the right as seen from the front, y up, z out of the front.
// The front is the inside of a window, the file's "back". source: measured from RADIANCE 6.1.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bsdf/scatter_table.h"
#include "bsdf/window_element.h"

namespace infra {

class Bsdf {
  public:
    /// Tables that reflect or transmit less than this beyond their Lambertian part are left out.
    static constexpr double least_total = 1e-3;

    ///   tables  one a direction at most
    Bsdf(BsdfDescription description, std::vector<std::unique_ptr<ScatterTable>> tables);

    /// What there is beyond the Lambertian parts, for light or a view from the front or back; nullptr for
    /// nothing. Of transmission from one side only the table is that of both.
    const ScatterTable* reflection(bool front) const { return reflection_[front].get(); }
    const ScatterTable* transmission(bool front) const {
        return transmission_[one_way_ ? way_ : front].get();
    }

    /// The Lambertian parts, as reflectance and transmittance.
    const Xyz& lambertian_reflectance(bool front) const { return lambertian_reflectance_[front]; }
    const Xyz& lambertian_transmittance(bool front) const { return lambertian_transmittance_[front]; }

    /// Resolution of all that a direction scatters to; pi where that is Lambertian.
    ResolutionRange resolution(const Vec3& in) const;

    const BsdfDescription& description() const { return description_; }

  private:
    BsdfDescription description_;
    std::unique_ptr<ScatterTable> reflection_[2], transmission_[2];  // [front]
    bool one_way_ = false, way_ = false;  ///< transmission is told from that side only
    Xyz lambertian_reflectance_[2] = {Xyz(0), Xyz(0)};
    Xyz lambertian_transmittance_[2] = {Xyz(0), Xyz(0)};
};

struct LoadedBsdf {
    std::shared_ptr<const Bsdf> bsdf;
    std::vector<std::string> warnings;  ///< complete lines, "file:line: ..."; the caller prints them
};

/// Reads and checks a file. Warns of values below 0, taken for 0, and of a reflectance or transmittance over
/// 1.01, as RADIANCE does.
///   throws  Error with file and line
LoadedBsdf load_bsdf(const std::string& path);
/// The same from text in memory; `name` stands for the file in errors.
LoadedBsdf parse_bsdf(std::string_view text, const std::string& name);

}  // namespace infra
