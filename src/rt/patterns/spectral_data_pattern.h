// Spectra that vary with the place, from a table whose last coordinate is the wavelength: specdata, specpict.
#pragma once

#include <memory>
#include <vector>

#include "common/data/data_table.h"
#include "common/spectra/resampler.h"
#include "rt/functions/functions.h"
#include "rt/modifier.h"

namespace infra {

class SpectralDataPattern final : public Modifier {
  public:
    static constexpr std::size_t most_wavelengths = 4096;

    /// String arguments: func file funcfile x1 x2.. transform, with func(value, nm).
    SpectralDataPattern(ModifierContext& context, std::shared_ptr<const DataTable> table);

    bool shade(Tracer& tracer, Interaction& at) const override;

  private:
    std::shared_ptr<const DataTable> table_;
    FunctionSet functions_;
    double nm_first_, nm_step_;
    std::vector<DataAxis::Cell> cells_;  ///< of evenly spaced wavelengths among the table's own
    Resampler resampler_;
};

}  // namespace infra
