// Units that spectral radiances come in.
#pragma once

#include <string>
#include <string_view>

#include "ir/genirsky/spectral_axis.h"

namespace infra::ir {

class SpectralUnit {
  public:
    /// One of choices(). throws Error that names them otherwise.
    static SpectralUnit parse(std::string_view text);
    /// "W/m2/sr/nm, mW/m2/sr/nm, .."
    static std::string choices();

    /// What the unit is per.
    SpectralAxis density() const { return density_; }
    /// A radiance in this unit as W m^-2 sr^-1/cm^-1 or W m^-2 sr^-1/um, as density() says.
    double watts(double radiance) const { return factor_ * radiance; }

    std::string_view name() const { return name_; }

  private:
    SpectralUnit(std::string_view name, double factor, SpectralAxis density)
        : name_(name), factor_(factor), density_(density) {}

    std::string_view name_;
    double factor_;
    SpectralAxis density_;
};

}  // namespace infra::ir
