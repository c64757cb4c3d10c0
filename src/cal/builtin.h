// Functions written in C++ that expressions can call.
#pragma once

#include <span>

#include "cal/host.h"

namespace infra::cal {

/// A function of already evaluated arguments. A result that is NaN or infinite is a domain error and becomes
/// 0.
struct Builtin {
    const char* name;
    int arity;  ///< arguments needed; more are ignored
    bool pure;  ///< depends on its arguments alone, so it may be folded
    double (*call)(const double* arguments, const Host&);  ///< arguments[0 .. arity)
};

/// sin, sqrt, rand, ... : what every program has apart from the lazy if, select, min and max.
std::span<const Builtin> core_builtins();

/// What the ray tracer has besides: arg, erf, noise3, source_corr, ...
std::span<const Builtin> ray_builtins();

}  // namespace infra::cal
