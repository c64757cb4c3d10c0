// glass: a thin clear pane that reflects and transmits without bending.
//
//     mod glass id
//     0
//     0
//     3 | 4 red green blue [refractive_index]
//
// The colour is the transmissivity of one passage at normal incidence; the index is 1.52 unless given.
// Fresnel's formulas for both polarisations, with all reflections inside the pane summed as a geometric
// series. source: RADIANCE reference manual, "Materials"; Born & Wolf, Principles of Optics, 1.5 and 7.6.
#include <algorithm>
#include <cmath>

#include "rt/compile/modifier_table.h"
#include "rt/materials/surface_material.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double usual_index = 1.52;
constexpr float opaque_below = 1e-15f;

/// A pane for one polarisation: reflectance of one face, transmissivity of one passage.
struct Pane {
    double face, inside;
    double transmittance() const {
        return (1 - face) * (1 - face) * inside / (1 - face * face * inside * inside);
    }
    double reflectance() const {
        return face + (1 - face) * (1 - face) * face * inside * inside / (1 - face * face * inside * inside);
    }
};

class Glass final : public SurfaceMaterial {
  public:
    Glass(std::string_view name, const Modifier* next, const Spectrum& color, double index)
        : SurfaceMaterial(name, next, true), color_(color), index_(index) {}

    void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const override {
        out.pure_specular = true;
        if (tracer.is_in_photon_map(*at.ray)) return;
        const double cosine = std::max(-dot(out.normal, at.ray->direction), 1e-6);
        const bool textured = at.textured();
        const double inner = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index_ * index_));
        const auto squared = [](double x) { return x * x; };
        const double across = squared((cosine - index_ * inner) / (cosine + index_ * inner));
        const double along = squared((index_ * cosine - inner) / (index_ * cosine + inner));

        const bool transmits = color_.maximum() > opaque_below;
        Spectrum reflected(color_.channels()), transmitted(color_.channels());
        for (int c = 0; c < color_.channels(); ++c) {
            const double passage = transmits ? std::pow(std::max(color_[c], opaque_below), 1.0 / inner) : 0.0;
            const Pane s{across, passage}, p{along, passage};
            transmitted.set(c, static_cast<float>(0.5 * (s.transmittance() + p.transmittance())));
            reflected.set(c, static_cast<float>(0.5 * (s.reflectance() + p.reflectance())));
        }
        if (transmits) {
            out.has_through = true;
            out.through_coefficient = transmitted * at.pattern;
            out.through_direction = at.ray->direction;
            const bool bends = textured && !shadow && !at.ray->is(ambient_rays);
            if (bends) {
                const Vec3 bent = at.ray->direction + at.perturbation * (2.0 * (1.0 - index_));
                if (length(bent) > 0) out.through_direction = normalize(bent);
            }
            out.seen_through = !bends;
        }
        if (shadow) return;
        out.has_mirror = true;
        out.mirror_coefficient = reflected;
        out.mirror_direction = at.ray->direction + out.normal * (2.0 * cosine);
        out.image_behind = tracer.is_flat(at) && (!textured || at.ray->is(ambient_rays));
    }

  private:
    Spectrum color_;
    double index_;
};

}  // namespace

std::unique_ptr<Modifier> make_glass(ModifierContext& context) {
    const auto numbers = context.reals();
    const double index = numbers.size() > 3 ? numbers[3] : usual_index;
    if (!(index >= 1)) throw context.error("refractive index must be at least 1");
    return std::make_unique<Glass>(context.name(), context.next, context.color(0), index);
}

}  // namespace infra
