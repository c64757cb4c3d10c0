// Vectors of the scene: GLM's, in double precision. Lengths are in scene units, directions have unit length.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace infra {

using Vec3 = glm::dvec3;

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Unit vector along v; v must not be zero.
inline Vec3 normalize(const Vec3& v) { return v / length(v); }

/// Two unit vectors that make a right-handed orthonormal frame (u, v, n) with the unit vector n.
/// source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017).
inline void make_frame(const Vec3& n, Vec3& u, Vec3& v) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    u = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace infra
