// BRTDfunc: a sheet all of whose reflection and transmission is programmed, front and back apart.
//
//     mod BRTDfunc id
//     10+ rrefl grefl brefl rtrns gtrns btrns rbrtd gbrtd bbrtd funcfile transform
//     0
//     9+ rfdif gfdif bfdif rbdif gbdif bbdif rtdif gtdif btdif A10 ..
//
// refl and trns are expressions, the coefficients of a mirror image and of what is seen straight through.
// brtd name functions of the direction to a light source and its solid angle as in plasfunc, or are 0; they
// answer for light from both sides. fdif, bdif and tdif are diffuse reflectance of front and back, and
// diffuse transmittance. A pattern colours the diffuse parts only; the expressions and functions find it in
// CrP CgP CbP. Nx Ny Nz and Rdot are those of the surface as it stands (Rdot is below 0 from behind), NxP NyP
// NzP and RdotP are turned to the viewer. Shadow rays pass through with trns. Indirect light is not seen in
// brtd. source: RADIANCE reference manual, "Materials".
#include <cmath>

#include "rt/compile/modifier_table.h"
#include "rt/materials/programmed_material.h"
#include "rt/materials/smoothing.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;  // a cosine or value of which nothing is seen
constexpr std::size_t mirror_expression = 0, through_expression = 3;
constexpr std::size_t first_function = 6;  // of the string arguments

/// The functions of red, green and blue, where names that are the same share a call.
class ResponseFunctions {
  public:
    ResponseFunctions(ModifierContext& context, FunctionSet& functions) {
        for (std::size_t i = 0; i < 3; ++i) add(context, functions, i);
    }

    /// False if all three are 0.
    bool any() const { return count_ > 0; }

    void call(FunctionCall& call, const Vec3& wi, double omega, double* rgb) const {
        const SourceArguments source(call, wi, omega);
        double values[3] = {};
        for (std::size_t i = 0; i < count_; ++i) values[i] = call.call(i, source.values);
        for (std::size_t i = 0; i < 3; ++i) rgb[i] = slot_[i] < 0 ? 0.0 : values[slot_[i]];
    }

  private:
    void add(ModifierContext& context, FunctionSet& functions, std::size_t i) {
        const auto names = context.strings().subspan(first_function, 3);
        if (names[i] == "0") return;
        for (std::size_t k = 0; k < i && slot_[i] < 0; ++k)
            if (names[k] == names[i]) slot_[i] = slot_[k];
        if (slot_[i] >= 0) return;
        slot_[i] = static_cast<int>(count_++);
        functions.add_function(context, first_function + i, 4);
    }

    std::size_t count_ = 0;
    int slot_[3] = {-1, -1, -1};  ///< the function of each colour among those of the set, -1: none
};

class BrtdResponse final : public SourceResponse {
  public:
    BrtdResponse(Tracer& tracer, const Interaction& at, const FunctionSet& functions,
                 const ResponseFunctions& rgb, const MaterialVariables& variables)
        : tracer_(tracer), at_(at), functions_(functions), rgb_(rgb), variables_(variables) {}

    void add(const Vec3& wi, double omega, Spectrum& result) const override {
        const double cosine = std::fabs(dot(variables_.normal, wi));
        if (cosine <= tiny) return;
        FunctionCall call(functions_, tracer_, at_, &variables_);
        double rgb[3];
        rgb_.call(call, wi, omega, rgb);
        constexpr double weight[3] = {0.265074126, 0.670114631, 0.064811243};  // of RADIANCE's brightness
        if (!call.ok() || rgb[0] * weight[0] + rgb[1] * weight[1] + rgb[2] * weight[2] <= tiny) return;
        result.add_scaled(tracer_.scene().channels().from_rgb(rgb[0], rgb[1], rgb[2]),
                          static_cast<float>(cosine));
    }

  private:
    Tracer& tracer_;
    const Interaction& at_;
    const FunctionSet& functions_;
    const ResponseFunctions& rgb_;
    MaterialVariables variables_;
};

class BrtdMaterial final : public SurfaceMaterial {
  public:
    BrtdMaterial(ModifierContext& context, bool transmits)
        : SurfaceMaterial(context.name(), context.next, transmits),
          front_(context.color(0)),
          back_(context.color(3)),
          through_(context.color(6)),
          functions_(context, mirror_expression, 6, 9),
          response_(context, functions_) {
        set_sides({.back_may_hide = false, .turns_to_viewer = false});
    }

    void scatter(Tracer& tracer, const Interaction& at, bool shadow, Scattering& out) const override {
        MaterialVariables variables =
            material_variables(tracer.scene().channels(), at, out.normal, at.pattern);
        variables.tells_sides = true;
        out.diffuse = (at.flipped ? back_ : front_) * at.pattern;
        out.diffuse_through = through_ * at.pattern;
        send_through(tracer, at, shadow, variables, out);
        if (shadow) return;
        reflect(tracer, at, variables, out);
        const bool reflects = out.diffuse.maximum() > tiny, transmits = out.diffuse_through.maximum() > tiny;
        if (reflects) out.ambient = out.diffuse;
        if (transmits) out.ambient_through = out.diffuse_through;
        out.pure_specular = !reflects && !transmits && !response_.any();
        if (response_.any()) out.set_response<BrtdResponse>(tracer, at, functions_, response_, variables);
    }

  private:
    /// Three expressions as a spectrum. False after a domain error.
    bool coefficient(Tracer& tracer, const Interaction& at, const MaterialVariables& variables,
                     std::size_t first, Spectrum& result) const {
        FunctionCall call(functions_, tracer, at, &variables);
        double rgb[3];
        for (std::size_t i = 0; i < 3; ++i) rgb[i] = call.expression(first + i);
        result = tracer.scene().channels().from_rgb(rgb[0], rgb[1], rgb[2]);
        return call.ok();
    }

    void send_through(Tracer& tracer, const Interaction& at, bool shadow, const MaterialVariables& variables,
                      Scattering& out) const {
        if (!coefficient(tracer, at, variables, through_expression, out.through_coefficient)) return;
        out.has_through = true;
        out.through_direction = at.ray->direction;
        const bool straight = !at.textured() || shadow || at.ray->is(ambient_rays);
        if (!straight && !is_smoothed(tracer, at)) {
            const Vec3 bent = at.ray->direction - at.perturbation;
            if (dot(bent, bent) > 0) out.through_direction = normalize(bent);
        }
        out.seen_through = straight && out.diffuse.brightness() + out.diffuse_through.brightness() < 1;
    }

    void reflect(Tracer& tracer, const Interaction& at, const MaterialVariables& variables,
                 Scattering& out) const {
        if (!coefficient(tracer, at, variables, mirror_expression, out.mirror_coefficient)) return;
        out.has_mirror = true;
        out.mirror_direction = at.ray->direction + variables.normal * (2.0 * variables.cosine);
        out.image_behind = tracer.is_flat(at) && (!at.textured() || at.ray->is(ambient_rays));
    }

    Spectrum front_, back_, through_;  ///< diffuse
    FunctionSet functions_;
    ResponseFunctions response_;
};

}  // namespace

std::unique_ptr<Modifier> make_brtdfunc(ModifierContext& context) {
    bool transmits = false;
    for (const std::string_view expression : context.strings().subspan(through_expression, 3))
        transmits = transmits || expression != "0";
    return std::make_unique<BrtdMaterial>(context, transmits);
}

}  // namespace infra
