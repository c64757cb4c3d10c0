// What brdftab says of a table, as text.
#pragma once

#include <functional>
#include <string>

#include "ir/brdftab/quality.h"
#include "ir/brdftab/repair.h"
#include "ir/brdftab/source.h"

namespace infra::ir {

/// Lines about source, cross-validation, extrapolation, reciprocity and interpolation. `f` is what was
/// tabulated.
std::string describe(const BrdfSource& source, const BrdfFunction& f, const BrdfTable& table);

/// "rms 1.2 %, up to 60 deg 2 % of the peak, largest 30 % at ...", or "none".
std::string difference_text(const Difference& difference);

/// A line about what clamp_energy did.
std::string energy_text(const EnergyRepair& repair);

/// A table of reflectance for light from each angle, towards each angle, and emissivity; "-" where there is
/// no node. `model_emissivity` adds a column when it is set.
std::string albedo_lines(const BrdfTable& table, const std::function<double(double)>& model_emissivity);

/// A complete line for stderr when the table reflects more than it receives, else "".
std::string energy_warning(const BrdfTable& table);

}  // namespace infra::ir
