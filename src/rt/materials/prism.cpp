// prism1, prism2: a sheet that turns light into one or two other directions.
//
//     mod prism1 id
//     5+ coef dx dy dz funcfile transform...
//     0
//     n A1 .. An
//
//     mod prism2 id
//     9+ coef1 dx1 dy1 dz1 coef2 dx2 dy2 dz2 funcfile transform...
//     0
//     n A1 .. An
//
// A ray that meets the sheet goes on in the direction dx dy dz, of any length, with the factor coef. Each
// flat surface, polygon or ring, also makes an image of every light source (sources/virtual_sources.cpp),
// where light that leaves the source towards the sheet's middle would be turned to; rays aimed at it are
// turned again and so must lead back to the source. For them DxA DyA DzA is the direction of the source that
// they go to, for others 0. Patterns and textures on it are without effect. source: RADIANCE reference
// manual, "Materials", and RADIANCE 6.1 as measured.
#include <algorithm>

#include "rt/compile/modifier_table.h"
#include "rt/functions/functions.h"
#include "rt/materials/scattering.h"
#include "rt/sources/light_relay.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double edge_on = 1e-6;     // cosine of a direction along the sheet
constexpr double negligible = 1e-6;  // coefficient that makes no image

/// Unit; zero if both are the same place.
Vec3 direction_to(const Vec3& target, const Vec3& from) {
    const double distance = length(target - from);
    return distance > 0 ? (target - from) / distance : Vec3{0};
}

class Prism final : public Modifier, public LightRelay {
  public:
    Prism(ModifierContext& context, int turns)
        : Modifier(context.name(), context.next),
          traits_{.name = context.name(), .relay = this},
          turns_(turns),
          functions_(context, 0, static_cast<std::size_t>(4 * turns), static_cast<std::size_t>(4 * turns)) {}

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

    int image_count() const override { return turns_; }
    bool project(Tracer& tracer, const RelaySurface& surface, const LightSource& source, int n,
                 Projection& image) const override;

  private:
    struct Turn {
        double coefficient;
        Vec3 direction;  ///< unit
    };
    bool turn(Tracer& tracer, const Interaction& at, const Vec3& to_light, int n, Turn& result) const;

    MaterialTraits traits_;
    int turns_;
    FunctionSet functions_;
};

// Where the n-th set of functions sends the ray. False if they have no value here, or no direction.
bool Prism::turn(Tracer& tracer, const Interaction& at, const Vec3& to_light, int n, Turn& result) const {
    FunctionCall call(functions_, tracer, at);
    call.set_light_direction(to_light);
    const auto value = [&](int i) { return call.expression(static_cast<std::size_t>(4 * n + i)); };
    result.coefficient = value(0);
    Vec3 direction;
    for (int i = 0; i < 3; ++i) direction[i] = value(1 + i);
    if (!call.ok()) return false;
    const double size = length(direction);
    if (!(size > 0) || !std::isfinite(size)) return false;
    result.direction = functions_.to_scene(tracer, at, direction / size);
    return true;
}

bool Prism::shade(Tracer& tracer, Interaction& at) const {
    const LightSource* image = image_aimed_at(tracer, at);
    if (!image && at.ray->aimed_source >= 0) return true;  // in the way of another source
    Vec3 to_light{0};
    if (image) {
        const LightSource& source = tracer.scene().source(image->parent);
        to_light = source.distant() ? source.center : direction_to(source.center, at.point);
    }
    const Spectrum* const blackbody = at.blackbody;
    at.blackbody = nullptr;  // emits what both turns together leave over
    double passed = 0;
    for (int n = 0; n < turns_; ++n) {
        Turn result;
        if ((image && image->image != n) || !turn(tracer, at, to_light, n, result)) continue;
        Scattering scattering(at.normal, at.channels());
        scattering.pure_specular = true;
        scattering.has_through = true;
        scattering.through_coefficient = Spectrum(at.channels(), static_cast<float>(result.coefficient));
        scattering.through_direction = result.direction;
        scattering.seen_through = tracer.is_flat(at);
        if (image) scattering.relayed_source = image->parent;
        tracer.transport(scattering, at);
        passed += std::max(0.0, result.coefficient);
    }
    at.blackbody = blackbody;
    if (blackbody) at.radiance.add_scaled(*blackbody, static_cast<float>(std::max(0.0, 1.0 - passed)));
    return true;
}

// The ray from the source through the sheet's middle, and where it is turned to, say how the sheet shears
// what lies behind it.
bool Prism::project(Tracer& tracer, const RelaySurface& surface, const LightSource& source, int n,
                    Projection& image) const {
    const Vec3 incident =
        source.distant() ? -source.center : direction_to(surface.disk.center, source.center);
    const double cosine = dot(incident, surface.normal);
    if (std::fabs(cosine) <= edge_on) return false;
    const Ray ray =
        tracer.primary(source.distant() ? surface.disk.center - incident : source.center, incident, 0);
    Interaction at(ray);
    if (!tracer.meet(surface.surface, at)) return false;
    Turn result;
    if (!turn(tracer, at, Vec3{0}, n, result) || result.coefficient <= negligible) return false;
    const double turned = dot(result.direction, surface.normal);
    if (std::fabs(turned) <= edge_on) return false;
    image = {surface.normal, surface.offset, result.direction / turned - incident / cosine, false};
    if ((turned > 0) != (cosine > 0)) image.shift -= surface.normal * 2.0;
    return true;
}

}  // namespace

std::unique_ptr<Modifier> make_prism1(ModifierContext& context) {
    return std::make_unique<Prism>(context, 1);
}

std::unique_ptr<Modifier> make_prism2(ModifierContext& context) {
    return std::make_unique<Prism>(context, 2);
}

}  // namespace infra
