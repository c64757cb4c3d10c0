// mist, as the compiler sees it; see mist.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "rt/compile/modifier_table.h"
#include "rt/volume/medium.h"

namespace infra {

class CompiledScene;

class Mist final : public Modifier {
  public:
    explicit Mist(ModifierContext& context);

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

    /// Finds the sources that it names among those of the scene, once they are all there. Warns of names that
    /// are none.
    void find_sources(const CompiledScene& scene, std::vector<std::string>& warnings);

  private:
    void add_to(Medium& medium, const Spectrum& extinction) const;
    void take_from(Medium& medium, const Spectrum& extinction, const Medium& open) const;
    bool is_known_to(const Medium& medium) const;

    MaterialTraits traits_;
    PrimitiveId number_;  ///< among those of the whole scene
    std::vector<std::string_view> source_names_;
    Medium added_;  ///< extinction besides what is there; albedo and eccentricity in place of what is there
    bool has_extinction_, has_albedo_, has_eccentricity_;
};

}  // namespace infra
