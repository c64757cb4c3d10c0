// The walk for processors with AVX2, and for all others; which one it is, is found when a program starts.
// Both find the same: they differ in the rounding of what is rounded outward anyway.
#include <cstring>

#include "rt/geometry/bvh_walk.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define INFRADIANCE_HAS_AVX2 1
#include <immintrin.h>
#endif

namespace infra {

#ifdef INFRADIANCE_HAS_AVX2
#pragma GCC push_options
#pragma GCC target("avx2,fma,bmi,bmi2")
namespace avx2 {
namespace {
// clang-format off
#include "rt/geometry/lanes_avx2.h"
#include "rt/geometry/bvh_kernel.h"
// clang-format on
}  // namespace
}  // namespace avx2
#pragma GCC pop_options
#endif

namespace portable {
namespace {
// clang-format off
#include "rt/geometry/lanes_portable.h"
#include "rt/geometry/bvh_kernel.h"
// clang-format on
}  // namespace
}  // namespace portable

namespace {

bool has_avx2() {
#ifdef INFRADIANCE_HAS_AVX2
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
#else
    return false;
#endif
}

}  // namespace

BvhKernel portable_bvh_kernel() { return portable::walk; }

BvhKernel best_bvh_kernel() {
#ifdef INFRADIANCE_HAS_AVX2
    if (has_avx2()) return avx2::walk;
#endif
    return portable_bvh_kernel();
}

}  // namespace infra
