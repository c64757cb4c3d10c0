// Radiance as the numbers that are written of it.
#pragma once

#include <array>
#include <variant>

#include "common/spectra/spectral_color.h"
#include "rt/programs/output_color.h"

namespace infra {

/// Chosen once a program. RGB and spectra pass as they are.
class ValueConverter {
  public:
    struct Numbers {
        int count = 0;
        std::array<float, Channels::most> values;
    };

    /// Keeps three channels.
    ValueConverter() : ValueConverter(OutputColor(), Channels()) {}
    ValueConverter(const OutputColor& color, const Channels& channels);

    /// Numbers a spectrum.
    int components() const { return components_; }

    /// Whether the numbers are the channels themselves.
    bool keeps_channels() const { return std::holds_alternative<Kept>(conversion_); }

    /// Of a reflectance or another share, which has no unit.
    Numbers share(const Spectrum& value) const;
    /// Of a radiance: tristimulus values and the eye's responses in lumens where the radiance is in watts.
    Numbers radiance(const Spectrum& value) const;

  private:
    struct Kept {};
    struct Mean {};

    std::variant<Kept, Mean, Response, ColorConverter> conversion_;
    float efficacy_ = 1;
    int components_;
};

}  // namespace infra
