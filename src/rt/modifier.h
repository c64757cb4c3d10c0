// A node of the compiled scene that a surface's chain of modifiers runs through: pattern, mixture or
// material.
#pragma once

#include <string_view>

namespace infra {

class Emitter;
class LightRelay;
class Tracer;
struct Interaction;

/// What the rest of the renderer must know of a material without running it.
struct MaterialTraits {
    std::string_view name;
    bool transparent = false;  ///< loses against an opaque surface in the same place; -i looks through it
    bool stands_for_others = false;  ///< for geometry near it (BSDF with a thickness): -i looks through it
    bool blocks_light = false;       ///< a shadow ray that meets it is certainly stopped
    bool emits = false;              ///< sends out radiance of its own, or a part of it does
    bool is_light = false;           ///< light, glow, spotlight, illum: not shaded white by -i
    bool is_mixture = false;         ///< stands for other materials: mixtures, antimatter
    const LightRelay* relay =
        nullptr;  ///< a flat surface of it makes images of light sources (mirror, prism)
};

class Modifier {
  public:
    explicit Modifier(std::string_view name, const Modifier* next) : name_(name), next_(next) {}
    virtual ~Modifier() = default;
    Modifier(const Modifier&) = delete;
    Modifier& operator=(const Modifier&) = delete;

    /// A material sets the interaction's radiance and answers true; a pattern multiplies its `pattern` and
    /// answers false. Materials run the patterns behind them (`next`) by themselves.
    virtual bool shade(Tracer& tracer, Interaction& at) const = 0;

    /// Traits if this node is a material, or a mixture of some.
    virtual const MaterialTraits* traits() const { return nullptr; }

    /// What makes it a light source, if it is one.
    virtual const Emitter* emitter() const { return nullptr; }

    std::string_view name() const { return name_; }
    /// What modifies this modifier.
    const Modifier* next() const { return next_; }

    /// First material (or mixture of materials) of a chain, nullptr when there is none.
    static const Modifier* material_of(const Modifier* chain) {
        while (chain && !chain->traits()) chain = chain->next();
        return chain;
    }

  private:
    std::string_view name_;
    const Modifier* next_;
};

}  // namespace infra
