#include "rt/materials/programmed_material.h"

#include <cmath>

#include "rt/compile/modifier_table.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;  // a cosine or value of which nothing is seen

/// The function's part of the light of a source.
class ProgrammedResponse final : public SourceResponse {
  public:
    ProgrammedResponse(Tracer& tracer, const Interaction& at, const ProgrammedValue& value,
                       const MaterialVariables& variables, const Spectrum& reflected,
                       const Spectrum& transmitted)
        : tracer_(tracer),
          at_(at),
          value_(value),
          variables_(variables),
          reflected_(reflected),
          transmitted_(transmitted) {}

    void add(const Vec3& wi, double omega, Spectrum& result) const override {
        const double cosine = dot(variables_.normal, wi);
        const Spectrum& coefficient = cosine > 0 ? reflected_ : transmitted_;
        if (std::fabs(cosine) <= tiny || coefficient.maximum() <= 0) return;
        double value;
        if (value_.evaluate(tracer_, at_, variables_, wi, omega, value) && value > tiny)
            result.add_scaled(coefficient, static_cast<float>(value * std::fabs(cosine)));
    }

  private:
    Tracer& tracer_;
    const Interaction& at_;
    const ProgrammedValue& value_;
    MaterialVariables variables_;
    Spectrum reflected_, transmitted_;  ///< factors of the value
};

}  // namespace

MaterialVariables material_variables(const Channels& channels, const Interaction& at, const Vec3& normal,
                                     const Spectrum& color) {
    MaterialVariables variables{.normal = normal, .cosine = -dot(normal, at.ray->direction), .color = {}};
    int counts[3] = {};
    for (int c = 0; c < color.channels(); ++c) {
        const int primary = channels.primary_of(c);
        variables.color[primary] += double(color[c]);
        ++counts[primary];
    }
    for (int i = 0; i < 3; ++i)
        if (counts[i] > 1) variables.color[i] /= counts[i];
    return variables;
}

ProgrammedMaterial::ProgrammedMaterial(ModifierContext& context, const ProgrammedShares& shares,
                                       ProgrammedValue::Kind kind)
    : SurfaceMaterial(context.name(), context.next, false), p_(shares), value_(context, kind) {}

// What the function sends where is unknown to the indirect calculation: it takes all of it as diffuse.
void ProgrammedMaterial::scatter(Tracer& tracer, const Interaction& at, bool, Scattering& out) const {
    const Spectrum color = p_.color * at.pattern;
    const auto colored = [&](double share) { return color * static_cast<float>(share); };
    const bool opaque = p_.transmitted <= tiny, lets_all_through = p_.transmitted >= 1.0 - tiny;
    Spectrum reflected(color.channels()), transmitted(color.channels());
    if (!lets_all_through) {
        out.diffuse = colored(1.0 - p_.transmitted - p_.reflected);
        out.ambient = colored(1.0 - p_.transmitted);
        if (p_.reflected > tiny)
            reflected = p_.metallic ? colored(p_.reflected)
                                    : Spectrum(color.channels(), static_cast<float>(p_.reflected));
    }
    if (!opaque) {
        out.diffuse_through = colored(p_.transmitted - p_.transmitted_specular);
        out.ambient_through = colored(p_.transmitted);
        if (p_.transmitted_specular > tiny) transmitted = colored(p_.transmitted_specular);
    }
    out.set_response<ProgrammedResponse>(tracer, at, value_,
                                         material_variables(tracer.scene().channels(), at, out.normal, color),
                                         reflected, transmitted);
}

ProgrammedShares reflecting_shares(const ModifierContext& context, bool metallic) {
    return {.color = context.color(0), .reflected = context.reals()[3], .metallic = metallic};
}

ProgrammedShares transmitting_shares(const ModifierContext& context) {
    const auto numbers = context.reals();
    ProgrammedShares shares{.color = context.color(0), .reflected = numbers[3]};
    shares.transmitted = numbers[4] * (1.0 - shares.reflected);
    shares.transmitted_specular = shares.transmitted * numbers[5];
    return shares;
}

}  // namespace infra
