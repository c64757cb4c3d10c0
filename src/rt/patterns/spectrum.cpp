// spectrum: multiplies each channel by the mean of a spectrum over its band.
//
//     mod spectrum id
//     0
//     0
//     5+ nmA nmB s1 s2 .. sn
//
// s1 belongs to the wavelength nmA, sn to nmB, the others lie evenly between them; each counts for one step,
// so that the spectrum covers half a step more than nmA..nmB at either end and is 0 beyond. In an RGB
// rendering it becomes a colour. source: RADIANCE reference manual, "Patterns".
#include "common/spectra/resampler.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/constant_spectrum.h"

namespace infra {

std::unique_ptr<Modifier> make_spectrum(ModifierContext& context) {
    const auto numbers = context.reals();
    const double nm_a = numbers[0], nm_b = numbers[1];
    if (!(nm_a > 0) || !(nm_b > 0) || nm_a == nm_b)
        throw context.error("nmA and nmB are not a range of wavelengths", "two wavelengths in nanometres");
    const auto values = numbers.subspan(2);
    const double half_step = 0.5 * (nm_b - nm_a) / static_cast<double>(values.size() - 1);
    reaches_channels(context, nm_a, nm_b);
    return std::make_unique<ConstantSpectrum>(
        context.name(), context.next, resample(context.channels, values, nm_a - half_step, nm_b + half_step));
}

}  // namespace infra
