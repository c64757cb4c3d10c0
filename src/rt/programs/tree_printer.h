// Writes every ray of a tree (rtrace -ot, -oT): children before their parents, each indented by its depth.
#pragma once

#include <string>

#include "rt/programs/output_letters.h"
#include "rt/settings.h"
#include "rt/tracer.h"

namespace infra {

class TreePrinter : public RayObserver {
  public:
    /// filter: only rays that meet a surface with one of these modifiers, or without (-ti, -te).
    TreePrinter(const CompiledScene& scene, const OutputSpec& spec, const NameFilter& filter,
                NumberFormat format, const ValueConverter& converter, std::string& out);

    void observe(const Interaction& at) override;

  private:
    bool passes(const Interaction& at) const;

    const CompiledScene& scene_;
    const OutputSpec& spec_;
    const NameFilter& filter_;
    ValueWriter writer_;
};

}  // namespace infra
