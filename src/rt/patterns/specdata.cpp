// specdata: multiplies each channel by the mean over its band of a spectrum that a data file has for this
// place.
//
//     mod specdata id
//     4+ func datafile funcfile x1 x2 .. xn transform
//     0
//     n A1 A2 .. An
//
// The file has n + 1 dimensions, the last of which is the wavelength in nm. func(value, nm) is asked at as
// many wavelengths as the file has, in equal steps; each counts for one step as in spectrum. source: RADIANCE
// reference manual, "Patterns".
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/spectral_data_pattern.h"

namespace infra {

std::unique_ptr<Modifier> make_specdata(ModifierContext& context) {
    auto table = shared_data(context, context.strings()[1]);
    if (table->dimensions() < 2)
        throw context.error("a data file of 1 dimension",
                            "specdata needs at least 2, the last is the wavelength");
    return std::make_unique<SpectralDataPattern>(context, std::move(table));
}

}  // namespace infra
