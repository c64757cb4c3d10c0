// The expressions and functions of a primitive that has a function file: brightfunc, mixdata and their kin.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cal/evaluator.h"
#include "cal/host.h"
#include "cal/program.h"
#include "rt/ray.h"
#include "scene/scene.h"
#include "scene/transform.h"

namespace infra {

class Geometry;
class ModifierContext;
class Tracer;

/// What the functions of a material see besides the hit itself: NxP NyP NzP, RdotP, CrP CgP CbP.
struct MaterialVariables {
    Vec3 normal;      ///< with its textures, facing the viewer
    double cosine;    ///< between it and the way back along the ray, above 0
    double color[3];  ///< of the material or of its patterns
    /// Nx Ny Nz and Rdot are those of the surface as it stands, so that its back can be told from its front;
    /// else they are turned to the viewer with the hit.
    bool tells_sides = false;
};

/// Expressions, functions, the transform into the coordinates they are written for, and the real arguments
/// they see.
class FunctionSet {
  public:
    /// Compiles `count` expressions from the string arguments [first, first + count); the function file's
    /// name is argument `file`, and a transform may follow both.
    ///   throws  Error for too few arguments, bad syntax, a missing file, a bad transform
    FunctionSet(ModifierContext& context, std::size_t first, std::size_t count, std::size_t file);

    /// Adds the function that a string argument names: FunctionCall::call(n, ...) calls the n-th one added.
    /// It may take fewer arguments than it is called with.
    ///   throws  Error for an unknown function, and one that needs more arguments
    void add_function(ModifierContext& context, std::size_t argument, int argument_count);

    /// Adds the expression that a string argument holds: the next one for FunctionCall::expression(n).
    void add_expression(ModifierContext& context, std::size_t argument);

    /// How many arguments the function takes that a string argument names; 0 if there is none.
    int arity(const ModifierContext& context, std::size_t argument) const;

    /// A vector turned by the primitive's own transform, without change of length.
    Vec3 turned(const Vec3& v) const { return from_local_.vector(v) / from_local_.magnification(); }
    /// The same, then turned with the instance that the hit lies in.
    Vec3 to_scene(const Tracer& tracer, const Interaction& at, const Vec3& v) const;
    /// A length, as a transform and an instance scale it.
    double length_in_scene(const Tracer& tracer, const Interaction& at, double length) const;

    /// Values of the expressions at a hit. False if one of them had a domain error: RADIANCE then leaves the
    /// modifier out.
    bool evaluate(Tracer& tracer, const Interaction& at, double* values) const;

  private:
    friend class FunctionCall;

    std::vector<cal::ExprId> expressions_;
    std::vector<cal::ExprId> functions_;
    Transform to_local_, from_local_;  ///< between the functions and the part of the scene they stand in
    std::span<const double> reals_;
    std::string context_;  ///< in which the function file's names stand
    std::string owner_;
    Location where_;
};

/// The use of a FunctionSet at one hit, on the stack.
class FunctionCall {
  public:
    /// variables: of the materials that have them, nullptr for the others; they must outlive the call.
    FunctionCall(const FunctionSet& set, Tracer& tracer, const Interaction& at,
                 const MaterialVariables* variables = nullptr);
    FunctionCall(const FunctionCall&) = delete;
    FunctionCall& operator=(const FunctionCall&) = delete;

    /// Values of the expressions, in order.
    void expressions(double* values);
    /// Value of the n-th of them.
    double expression(std::size_t n);
    double call(std::size_t function, std::span<const double> arguments);
    double call(std::size_t function, double argument) { return call(function, std::span(&argument, 1)); }

    /// DxA DyA DzA: where a prism's light source is, in the scene's coordinates; it must outlive the call.
    void set_light_direction(const Vec3& direction) { light_direction_ = &direction; }

    /// A direction of the scene in the coordinates that the functions are written for, unit length.
    Vec3 to_local(const Vec3& v) const {
        return {local_direction(v, 0), local_direction(v, 1), local_direction(v, 2)};
    }

    /// Whether there was no domain error so far.
    bool ok() const { return evaluator_.fault_count() == faults_; }

  private:
    void place(const Geometry& geometry);
    static double channel_value(const void* self, int number);
    double material_value(int number) const;
    double local_direction(const Vec3& v, int i) const;
    [[noreturn]] void fail(const Error& error) const;

    const FunctionSet& set_;
    const Interaction& at_;
    const Transform* to_local_;        ///< from the scene's coordinates to the functions'
    std::optional<Transform> placed_;  ///< that transform if they stand in an instance
    const MaterialVariables* variables_;
    const Vec3* light_direction_ = nullptr;
    cal::Evaluator& evaluator_;
    cal::Host host_;
    std::uint64_t faults_;
};

}  // namespace infra
