// How primitive types differ from RADIANCE's, for the reference page. The only place where that is written.
#pragma once

#include <map>
#include <string_view>

#include "scene/primitive_types.h"

namespace infra {

inline std::string_view type_remark(PrimitiveType type) {
    using enum PrimitiveType;
    constexpr std::string_view any_orientation =
        "an orientation that is zero, along the normal or undefined: the same all around, without a warning";
    constexpr std::string_view coincident =
        "in the same place as another surface: the rule for coincident surfaces, not whichever is met first";
    constexpr std::string_view relays =
        "one that is not flat is warned of once, not for each surface; images of images are dropped only if "
        "no "
        "straight line passes all mirrors, where RADIANCE loses some (up to 15 % of a value)";
    constexpr std::string_view bsdf =
        "colours as the file says, not rounded to 8 bits; a file with too few or too many numbers, or "
        "without "
        "visible data, is an error";
    static const std::map<PrimitiveType, std::string_view> remarks = {
        {instance, coincident},
        {mesh, coincident},
        {plastic2, any_orientation},
        {metal2, any_orientation},
        {trans2, any_orientation},
        {ashik2, any_orientation},
        {mirror, relays},
        {prism1, relays},
        {prism2, relays},
        {BSDF, bsdf},
        {aBSDF, bsdf},
        {dielectric, "what lies beyond one scatters by -mg, not evenly"},
        {mist,
         "seen through the hole that antimatter cut; relays (mirror>lamp) are always found, where RADIANCE "
         "may "
         "say \"unknown source\""},
        {BRTDfunc,
         "a function with a domain error is always left out; gbrtd and bbrtd count where rbrtd is 0 and "
         "nothing "
         "is diffuse"},
        {WGMDfunc, "an opaque one blocks shadow rays from behind with -bv 0"},
        {light,
         "samples on round ones are evenly spread with -dj above 0 (RADIANCE's disk comes out 2.4 % low)"},
        {spotlight,
         "one that barely grazes a mirror may keep an image that RADIANCE drops with -dp, or the reverse"},
        {colorpict, "OpenEXR too; one channel counts as grey"},
        {mixpict, "OpenEXR too; one channel counts as grey"},
        {specpict, "OpenEXR too; outside the channels' wavelengths: 0 with one warning"},
        {spectrum, "outside the channels' wavelengths: 0 with one warning"},
        {specfile, "outside the channels' wavelengths: 0 with one warning; unequal steps are warned of"},
        {specdata, "outside the channels' wavelengths: 0 with one warning"},
        {specfunc,
         "over a part of the range the samples' step divides it (RADIANCE's values are shifted by up to one "
         "step)"},
        {brightdata, "up to 16 dimensions, not 6; a number too many in the file is an error"},
        {colordata, "up to 16 dimensions, not 6; a number too many in the file is an error"},
        {texdata, "up to 16 dimensions, not 6; a number too many in the file is an error"},
        {mixdata, "up to 16 dimensions, not 6; a number too many in the file is an error"},
    };
    const auto found = remarks.find(type);
    return found == remarks.end() ? std::string_view() : found->second;
}

}  // namespace infra
