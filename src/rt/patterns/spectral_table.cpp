#include "rt/patterns/spectral_table.h"

#include <array>

#include "common/format.h"
#include "common/spectra/spectral_color.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/constant_spectrum.h"
#include "rt/tracer.h"

namespace infra {

SpectralTablePattern::SpectralTablePattern(ModifierContext& context, std::shared_ptr<const DataTable> table)
    : Modifier(context.name(), context.next),
      table_(std::move(table)),
      functions_(context, 3, table_->dimensions() - 1, 2) {
    functions_.add_function(context, 0, 2);
    const DataAxis& axis = table_->last_axis();
    if (!(axis.begin() > 0) || !(axis.end() > 0))
        throw context.error(formatted("%g to %g is not a range of wavelengths", axis.begin(), axis.end()),
                            "the last dimension is the wavelength in nm");
    if (axis.size() > most_wavelengths)
        throw context.error(formatted("%zu wavelengths", axis.size()),
                            formatted("at most %zu", most_wavelengths));
    reaches_channels(context, axis.begin(), axis.end());
    nm_first_ = axis.begin();
    nm_step_ = (axis.end() - axis.begin()) / static_cast<double>(axis.size() - 1);
    for (std::size_t i = 0; i < axis.size(); ++i)
        cells_.push_back(axis.locate(nm_first_ + nm_step_ * static_cast<double>(i)));
}

bool SpectralTablePattern::shade(Tracer& tracer, Interaction& at) const {
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
    at.pattern *=
        resample(tracer.scene().channels(), std::span(wanted).first(count), nm_first_ - 0.5 * nm_step_,
                 nm_first_ + nm_step_ * (static_cast<double>(count) - 0.5));
    return false;
}

}  // namespace infra
