// thermal: a surface that has a temperature.
//
//     mod thermal id
//     0 | 1 material
//     0
//     3 | 4 T lmin lmax [emissivity]
//
// Radiance leaving is what `material` reflects and transmits plus what it emits at T kelvin in the band
// lmin..lmax um: by Kirchhoff's law 1 less its directional reflectance and transmittance, times Planck's
// radiance. The reflectance is that of the very rays that are traced, with the material's patterns and
// textures, so that an enclosure of one temperature is exactly that bright. Without a material, or with void,
// the surface is black. A stated emissivity, 0..1, replaces the derived one. Patterns on `mod` multiply T:
// with T = 1 and a brightdata of kelvins the surface has a temperature map. Both sides emit; the surface is
// never sampled as a light source but found by indirect rays, lobes and mirrors. In a spectral rendering each
// channel gets its own part of the band (common/spectra/channels.h).
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "common/format.h"
#include "common/planck/planck.h"
#include "common/planck/planck_curve.h"
#include "common/planck/planck_response.h"
#include "rt/compile/table_cache.h"
#include "rt/materials/light_material.h"
#include "rt/materials/wrapper.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double no_emissivity = -1;    // stated
constexpr double unlikely_below = 100;  // kelvin: such numbers are degrees Celsius

/// Planck's radiance by channel.
class ThermalSpectrum {
  public:
    ThermalSpectrum(ModifierContext& context, double lo_um, double hi_um) {
        const Channels& channels = context.channels;
        for (int c = 0; c < channels.count(); ++c) {
            const double lo = channels.is_rgb() ? lo_um : std::max(lo_um, channels.lower_um(c));
            const double hi = channels.is_rgb() ? hi_um : std::min(hi_um, channels.upper_um(c));
            auto& curve = curves_.emplace_back();
            const bool emits = c < channels.bands();  // into the first component
            if (emits && lo < hi) curve = context.tables.planck_curve(lo, hi);
        }
        scale_ = channels.is_rgb() ? 1.0 : channels.bands();
    }

    /// temperature: kelvin, > 0.
    double radiance(int c, double temperature) const {
        const auto& curve = curves_[static_cast<std::size_t>(c)];
        return curve ? scale_ * curve->radiance(temperature) : 0.0;
    }
    /// Whether two channels have the same radiance at any temperature.
    bool same(int c, int d) const {
        return curves_[static_cast<std::size_t>(c)] == curves_[static_cast<std::size_t>(d)];
    }

  private:
    std::vector<std::shared_ptr<const PlanckCurve>> curves_;  ///< nullptr where the band leaves a channel out
    double scale_;
};

class ThermalMaterial final : public Modifier, public Emitter {
  public:
    ThermalMaterial(ModifierContext& context, const Modifier* reflecting)
        : Modifier(context.name(), context.next),
          Emitter(Kind::glow, Spectrum(context.channels.count(), 1.0f)),
          traits_(wrapper_traits(context.name(), reflecting)),
          reflecting_(reflecting),
          temperature_(context.reals()[0]),
          emissivity_(context.reals().size() > 3 ? context.reals()[3] : no_emissivity),
          spectrum_(context, context.reals()[1], context.reals()[2]) {
        if (!next()) blackbody_radiance(Spectrum(context.channels.count(), 1.0f), radiance_);
    }

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }
    const Emitter* emitter() const override { return this; }

  private:
    /// False for a temperature that is not above 0 K, or infinite.
    bool blackbody_radiance(const Spectrum& pattern, Spectrum& result) const;
    void shade_surface(Tracer& tracer, Interaction& at, const Spectrum& blackbody) const;

    MaterialTraits traits_;
    const Modifier* reflecting_;
    double temperature_;
    double emissivity_;
    ThermalSpectrum spectrum_;
};

bool ThermalMaterial::blackbody_radiance(const Spectrum& pattern, Spectrum& result) const {
    for (int c = 0; c < pattern.channels(); ++c) {
        if (c > 0 && pattern[c] == pattern[c - 1] && spectrum_.same(c, c - 1)) {
            result.set(c, result[c - 1]);
            continue;
        }
        const double temperature = temperature_ * double(pattern[c]);
        if (!(temperature > 0) || std::isinf(temperature)) return false;
        result.set(c, static_cast<float>(spectrum_.radiance(c, temperature)));
    }
    return true;
}

bool ThermalMaterial::shade(Tracer& tracer, Interaction& at) const {
    if (at.ray->is(shadow_rays)) return !reflecting_ || tracer.shade_chain(reflecting_, at);
    if (at.cosine < 0 && !tracer.settings().back_faces_visible) {
        tracer.pass_through(at);
        return true;
    }
    if (!next() && at.pattern == Spectrum(at.channels(), 1.0f)) {
        shade_surface(tracer, at, radiance_);
        return true;
    }
    Spectrum pattern(at.channels()), blackbody(at.channels());
    emission_pattern(*this, tracer, at, pattern);
    if (!blackbody_radiance(pattern, blackbody)) {
        blackbody.clear();
        tracer.count_bad_temperature();
    }
    shade_surface(tracer, at, blackbody);
    return true;
}

void ThermalMaterial::shade_surface(Tracer& tracer, Interaction& at, const Spectrum& blackbody) const {
    const bool stated = emissivity_ != no_emissivity;
    if (reflecting_) {
        at.blackbody = stated ? nullptr : &blackbody;
        tracer.shade_chain(reflecting_, at);
        at.blackbody = nullptr;
        if (!stated) return;
    }
    at.radiance.add_scaled(blackbody, stated ? static_cast<float>(emissivity_) : 1.0f);
}

}  // namespace

std::unique_ptr<Modifier> make_thermal(ModifierContext& context) {
    const auto numbers = context.reals();
    const double temperature = numbers[0], lo_um = numbers[1], hi_um = numbers[2];
    if (!(temperature > 0))
        throw context.error(formatted("temperature %g K is not above 0", temperature),
                            "T is in kelvin; with patterns it is their factor");
    if (!(lo_um < hi_um) || lo_um < shortest_wavelength_um || hi_um > longest_wavelength_um)
        throw context.error(formatted("%g to %g um is not a band", lo_um, hi_um),
                            formatted("wavelengths in um from %g to %g, the shorter one first",
                                      shortest_wavelength_um, longest_wavelength_um));
    if (numbers.size() > 3 && !(numbers[3] >= 0 && numbers[3] <= 1))
        throw context.error(formatted("emissivity %g is not within 0..1", numbers[3]));
    const Modifier* reflecting = wrapped_material(context);
    const Modifier* material = Modifier::material_of(reflecting);
    if (material && material->traits()->emits)
        throw context.error("\"" + std::string(material->name()) + "\" emits by itself",
                            "thermal takes a material that reflects or transmits");
    if (context.next == nullptr && temperature < unlikely_below)
        context.warnings.push_back(context
                                       .error(formatted("temperature %g K", temperature),
                                              "T is in kelvin; is this in degrees Celsius?")
                                       .what());
    context.tables.thermal_bands.add(lo_um, hi_um);
    return std::make_unique<ThermalMaterial>(context, reflecting);
}

}  // namespace infra
