// specfile: multiplies each channel by the mean over its band of a spectrum from a data file.
//
//     mod specfile id
//     1 datafile
//     0
//     0
//
// The file has one dimension, the wavelength in nm; each value counts for one step as in spectrum.
// Wavelengths in unequal steps are read as RADIANCE 6.1 reads them, which is wrong and therefore warned of:
// as many values as the file has, taken at half its mean step from the begin on, are stretched over the whole
// range.
#include "common/format.h"
#include "common/spectra/resampler.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/constant_spectrum.h"

namespace infra {

std::unique_ptr<Modifier> make_specfile(ModifierContext& context) {
    const auto table = shared_data(context, context.strings()[0]);
    if (table->dimensions() != 1)
        throw context.error(formatted("a data file of %zu dimensions", table->dimensions()),
                            "specfile needs one, the wavelength in nm");
    const DataAxis& axis = table->last_axis();
    if (!(axis.begin() > 0) || !(axis.end() > 0))
        throw context.error(formatted("%g to %g is not a range of wavelengths", axis.begin(), axis.end()));
    if (!axis.even())
        context.warnings.push_back(context
                                       .error("wavelengths in unequal steps are stretched, as RADIANCE does",
                                              "write them in equal steps, or use specdata")
                                       .what());
    reaches_channels(context, axis.begin(), axis.end());

    const std::size_t steps = (axis.even() ? axis.size() : 2 * axis.size()) - 1;
    const double step = (axis.end() - axis.begin()) / static_cast<double>(steps);
    std::vector<double> values(axis.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double nm = axis.begin() + step * static_cast<double>(i);
        values[i] = table->value({&nm, 1});
    }
    return std::make_unique<ConstantSpectrum>(
        context.name(), context.next,
        resample(context.channels, values, axis.begin() - 0.5 * step, axis.end() + 0.5 * step));
}

}  // namespace infra
