// Two chains of modifiers in one place: a share of each, or one of them.
#pragma once

#include "rt/modifier.h"

namespace infra {

class ModifierContext;

class Mixture : public Modifier {
  public:
    /// Foreground and background are the first two string arguments.
    ///   throws  Error for unknown names, and for a modifier on a mixture of materials
    explicit Mixture(ModifierContext& context);

    const MaterialTraits* traits() const final { return mixes_materials_ ? &traits_ : nullptr; }

  protected:
    const Modifier* foreground() const { return foreground_; }
    const Modifier* background() const { return background_; }

  private:
    MaterialTraits traits_;
    const Modifier* foreground_;
    const Modifier* background_;
    bool mixes_materials_;
};

/// Shares of both. Where only one of the two has a material the other lets the ray pass. As in RADIANCE 6.1
/// what a boundary says of the medium before it is lost: a ray that starts within a body of the mixture loses
/// nothing on its way out.
class Blend : public Mixture {
  public:
    using Mixture::Mixture;

    bool shade(Tracer& tracer, Interaction& at) const final;

  protected:
    /// The foreground's share at a hit, brought within 0..1 by the caller. False: the mixture is left out.
    virtual bool foreground_share(Tracer& tracer, const Interaction& at, double& share) const = 0;
};

}  // namespace infra
