// The functions that every program's expressions have.
#include <cmath>

#include "cal/builtin.h"
#include "cal/noise.h"

namespace infra::cal {
namespace {

template <double (*function)(double)>
double call1(const double* a, const Host&) {
    return function(a[0]);
}

constexpr Builtin core[] = {
    {"acos", 1, true, call1<std::acos>},
    {"asin", 1, true, call1<std::asin>},
    {"atan", 1, true, call1<std::atan>},
    {"atan2", 2, true, [](const double* a, const Host&) { return std::atan2(a[0], a[1]); }},
    {"ceil", 1, true, call1<std::ceil>},
    {"cos", 1, true, call1<std::cos>},
    {"exp", 1, true, call1<std::exp>},
    {"floor", 1, true, call1<std::floor>},
    {"log", 1, true, call1<std::log>},
    {"log10", 1, true, call1<std::log10>},
    {"rand", 1, true, call1<hash_random>},
    {"sin", 1, true, call1<std::sin>},
    {"sqrt", 1, true, call1<std::sqrt>},
    {"tan", 1, true, call1<std::tan>},
};

}  // namespace

std::span<const Builtin> core_builtins() { return core; }

}  // namespace infra::cal
