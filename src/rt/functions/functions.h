// The expressions and functions of a primitive that has a function file: brightfunc, mixdata and their kin.
#pragma once

#include <span>
#include <vector>

#include "cal/evaluator.h"
#include "cal/host.h"
#include "cal/program.h"
#include "rt/ray.h"
#include "scene/scene.h"
#include "scene/transform.h"

namespace infra {

class ModifierContext;
class Tracer;

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

    /// How many arguments the function takes that a string argument names; 0 if there is none.
    int arity(const ModifierContext& context, std::size_t argument) const;

    /// A vector from the function's coordinates to those of the scene, without change of length.
    Vec3 to_scene(const Vec3& v) const { return from_local_.vector(v) / from_local_.magnification(); }

    /// Values of the expressions at a hit. False if one of them had a domain error: RADIANCE then leaves the
    /// modifier out.
    bool evaluate(Tracer& tracer, const Interaction& at, double* values) const;

  private:
    friend class FunctionCall;

    std::vector<cal::ExprId> expressions_;
    std::vector<cal::ExprId> functions_;
    Transform to_local_, from_local_;
    double scale_;
    std::span<const double> reals_;
    std::string context_;  ///< in which the function file's names stand
    std::string owner_;
    Location where_;
};

/// The use of a FunctionSet at one hit, on the stack.
class FunctionCall {
  public:
    FunctionCall(const FunctionSet& set, Tracer& tracer, const Interaction& at);
    FunctionCall(const FunctionCall&) = delete;
    FunctionCall& operator=(const FunctionCall&) = delete;

    /// Values of the expressions, in order.
    void expressions(double* values);
    double call(std::size_t function, std::span<const double> arguments);
    double call(std::size_t function, double argument) { return call(function, std::span(&argument, 1)); }

    /// Whether there was no domain error so far.
    bool ok() const { return evaluator_.fault_count() == faults_; }

  private:
    static double channel_value(const void* self, int number);
    double local_direction(const Vec3& v, int i) const;
    [[noreturn]] void fail(const Error& error) const;

    const FunctionSet& set_;
    const Interaction& at_;
    cal::Evaluator& evaluator_;
    cal::Host host_;
    std::uint64_t faults_;
};

}  // namespace infra
