// The expressions of a primitive that has a function file: brightfunc, mixfunc and their kin.
#pragma once

#include <vector>

#include "cal/host.h"
#include "cal/program.h"
#include "rt/ray.h"
#include "scene/scene.h"
#include "scene/transform.h"

namespace infra {

class ModifierContext;
class Tracer;

/// Expressions, the transform into the coordinates they are written for, and the real arguments they see.
class FunctionSet {
  public:
    /// Compiles `count` expressions from the string arguments [first, first + count); the function file's
    /// name is argument `file`, and a transform may follow it.
    ///   throws  Error for too few arguments, bad syntax, a missing file, a bad transform
    FunctionSet(ModifierContext& context, std::size_t first, std::size_t count, std::size_t file);

    /// A vector from the function's coordinates to those of the scene, without change of length.
    Vec3 to_scene(const Vec3& v) const { return from_local_.vector(v) / from_local_.magnification(); }

    /// Values at a hit. False if one of them had a domain error: RADIANCE then leaves the modifier out.
    bool evaluate(Tracer& tracer, const Interaction& at, double* values) const;

  private:
    std::vector<cal::ExprId> expressions_;
    Transform to_local_, from_local_;
    double scale_;
    std::span<const double> reals_;
    std::string owner_;
    Location where_;
};

}  // namespace infra
