// ashik2: a coat that shines more along one direction than along the other, over a diffuse base.
//
//     mod ashik2 id
//     4+ ux uy uz funcfile transform
//     0
//     8 dred dgreen dblue sred sgreen sblue u-power v-power
//
// Diffuse colour, specular colour (the reflectance straight on, which grows to 1 towards grazing) and the
// powers, 0 or more, of a cosine along the vector ux uy uz and across it: the larger, the more like a mirror.
// The two colours should add up to less than 1. source: RADIANCE reference manual, "Materials"; model:
// lobes/ashikhmin.h.
#include "rt/compile/modifier_table.h"
#include "rt/lobes/ashikhmin.h"
#include "rt/materials/orientation.h"
#include "rt/materials/surface_material.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;

class Ashik2 final : public SurfaceMaterial {
  public:
    explicit Ashik2(ModifierContext& context)
        : SurfaceMaterial(context.name(), context.next, false),
          diffuse_(context.color(0)),
          specular_(context.color(3)),
          power_u_(context.reals()[6]),
          power_v_(context.reals()[7]),
          orientation_(context) {
        if (!(power_u_ >= 0 && power_v_ >= 0))
            throw context.error("u-power and v-power must not be negative");
    }

    void scatter(Tracer& tracer, const Interaction& at, bool, Scattering& out) const override {
        out.diffuse = diffuse_ * at.pattern;
        out.schlick_coupled = true;
        out.ambient = out.diffuse;
        if (specular_.maximum() <= tiny) return;

        const double sharing = schlick_share(std::max(-dot(out.normal, at.ray->direction), 0.001));
        Spectrum specular(specular_.channels(), static_cast<float>(sharing));
        specular.add_scaled(specular_, static_cast<float>(1.0 - sharing));
        const bool sampled = tracer.settings().specular_threshold < specular_.brightness() - tiny;
        out.add_lobe<AshikhminReflection>(sampled, specular, setting(tracer, at, out.normal));
        if (!sampled && out.diffuse.maximum() > tiny) out.ambient += specular;
    }

  private:
    AshikhminSetting setting(Tracer& tracer, const Interaction& at, const Vec3& normal) const {
        AshikhminSetting s{at.ray->direction, {},       at.normal,
                           power_u_,          power_v_, tracer.settings().specular_samples};
        if (!orientation_.frame(tracer, at, normal, s.frame)) {
            constexpr double least = 1e-5;  // keeps the mean finite
            s.power_u = s.power_v = 2 / (1 / (power_u_ + least) + 1 / (power_v_ + least));
        }
        return s;
    }

    Spectrum diffuse_, specular_;
    double power_u_, power_v_;
    Orientation orientation_;
};

}  // namespace

std::unique_ptr<Modifier> make_ashik2(ModifierContext& context) { return std::make_unique<Ashik2>(context); }

}  // namespace infra
