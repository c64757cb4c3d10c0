// Two chains of modifiers seen in one place, each with its share.
#pragma once

#include "rt/modifier.h"

namespace infra {

class ModifierContext;

/// Where only one of the two has a material the other lets the ray pass.
class Mixture : public Modifier {
  public:
    /// Foreground and background are the first two string arguments.
    ///   throws  Error for unknown names, and for a modifier on a mixture of materials
    explicit Mixture(ModifierContext& context);

    bool shade(Tracer& tracer, Interaction& at) const final;
    const MaterialTraits* traits() const final { return mixes_materials_ ? &traits_ : nullptr; }

  protected:
    /// The foreground's share at a hit, brought within 0..1 by the caller. False: the mixture is left out.
    virtual bool foreground_share(Tracer& tracer, const Interaction& at, double& share) const = 0;

  private:
    MaterialTraits traits_;
    const Modifier* foreground_;
    const Modifier* background_;
    bool mixes_materials_;
};

}  // namespace infra
