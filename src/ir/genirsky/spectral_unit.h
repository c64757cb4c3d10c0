// Units that spectral radiances come in.
#pragma once

#include <string>
#include <string_view>

namespace infra::ir {

class SpectralUnit {
  public:
    /// One of choices(). throws Error that names them otherwise.
    static SpectralUnit parse(std::string_view text);
    /// "W/m2/sr/nm, mW/m2/sr/nm, .."
    static std::string choices();

    /// A radiance in this unit as W m^-2 sr^-1/cm^-1; wavenumber in cm^-1.
    double per_wavenumber(double radiance, double wavenumber) const;

    std::string_view name() const { return name_; }

  private:
    SpectralUnit(std::string_view name, double factor, double per_um)
        : name_(name), factor_(factor), per_um_(per_um) {}

    std::string_view name_;
    double factor_;  ///< to W m^-2 sr^-1, by wavelength or by wavenumber
    double per_um_;  ///< lengths of the unit in a micrometre; 0: by wavenumber
};

}  // namespace infra::ir
