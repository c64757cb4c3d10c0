#include "rt/patterns/spectral_data_pattern.h"

#include <array>

#include "common/format.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/constant_spectrum.h"
#include "rt/tracer.h"

namespace infra {

namespace {

double step_of(const DataAxis& axis) {
    return (axis.end() - axis.begin()) / static_cast<double>(axis.size() - 1);
}

/// Of spectra in equal steps from end to end of the axis, each the middle of a band. throws Error for an axis
/// that is not one of wavelengths
Resampler resampler_of(ModifierContext& context, const DataAxis& axis) {
    if (!(axis.begin() > 0) || !(axis.end() > 0))
        throw context.error(formatted("%g to %g is not a range of wavelengths", axis.begin(), axis.end()),
                            "the last dimension is the wavelength in nm");
    if (axis.size() > SpectralDataPattern::most_wavelengths)
        throw context.error(formatted("%zu wavelengths", axis.size()),
                            formatted("at most %zu", SpectralDataPattern::most_wavelengths));
    reaches_channels(context, axis.begin(), axis.end());
    const double half_step = 0.5 * step_of(axis);
    return {context.channels, axis.size(), axis.begin() - half_step, axis.end() + half_step};
}

}  // namespace

SpectralDataPattern::SpectralDataPattern(ModifierContext& context, std::shared_ptr<const DataTable> table)
    : Modifier(context.name(), context.next),
      table_(std::move(table)),
      functions_(context, 3, table_->dimensions() - 1, 2),
      nm_first_(table_->last_axis().begin()),
      nm_step_(step_of(table_->last_axis())),
      resampler_(resampler_of(context, table_->last_axis())) {
    functions_.add_function(context, 0, 2);
    const DataAxis& axis = table_->last_axis();
    for (std::size_t i = 0; i < axis.size(); ++i)
        cells_.push_back(axis.locate(nm_first_ + nm_step_ * static_cast<double>(i)));
}

bool SpectralDataPattern::shade(Tracer& tracer, Interaction& at) const {
    std::array<double, DataTable::most_dimensions> place;
    std::array<double, most_wavelengths> stored, wanted;
    const std::size_t count = cells_.size();

    FunctionCall call(functions_, tracer, at);
    call.expressions(place.data());
    table_->vector(std::span(place).first(table_->dimensions() - 1), std::span(stored).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        const DataAxis::Cell& cell = cells_[i];
        const double value = cell.first * stored[cell.index] + cell.second * stored[cell.index + 1];
        const double nm = nm_first_ + nm_step_ * static_cast<double>(i);
        const double arguments[2] = {value, nm};
        wanted[i] = call.call(0, arguments);
    }
    if (!call.ok()) return false;
    at.pattern *= resampler_(std::span(wanted).first(count));
    return false;
}

}  // namespace infra
