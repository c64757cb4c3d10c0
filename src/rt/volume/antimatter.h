// antimatter, as the compiler sees it; see antimatter.cpp.
#pragma once

#include <vector>

#include "rt/compile/modifier_table.h"

namespace infra {

class Antimatter final : public Modifier {
  public:
    explicit Antimatter(ModifierContext& context);

    bool shade(Tracer& tracer, Interaction& at) const override;
    const MaterialTraits* traits() const override { return &traits_; }

    /// Modifiers of the surfaces that it cuts, sorted.
    const std::vector<PrimitiveId>& modifiers() const { return modifiers_; }

  private:
    bool is_inside_body(const Tracer& tracer, const Interaction& at) const;

    MaterialTraits traits_;
    std::vector<PrimitiveId> modifiers_;
    const Modifier* shading_ = nullptr;  ///< of the cut face
    bool shows_cut_ = false;
};

}  // namespace infra
