// specpict: multiplies each channel by the mean over its band of the spectra of a picture.
//
//     mod specpict id
//     5+ func specfile funcfile u v transform
//     0
//     n A1 A2 .. An
//
// func(value, nm) is asked at the middle of each of the picture's bands; u and v as in colorpict. source:
// RADIANCE reference manual, "Patterns".
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/patterns/spectral_data_pattern.h"

namespace infra {

std::unique_ptr<Modifier> make_specpict(ModifierContext& context) {
    return std::make_unique<SpectralDataPattern>(context,
                                                 shared_spectral_picture(context, context.strings()[1]));
}

}  // namespace infra
