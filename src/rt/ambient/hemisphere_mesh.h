// How irradiance changes with the place, from what a hemisphere of rays has seen.
//
// The ends of the rays make a mesh of triangles; each is taken to be as bright as the farthest of its
// corners. The irradiance that they give is a sum over their edges, so its derivatives are known exactly.
// source: Schwarzhaupt, Wann Jensen & Jarosz, "Practical Hessian-Based Error Control for Irradiance Caching",
// ACM TOG 31 (2012); the integrals along an edge are written here over the angle at which it is seen.
#pragma once

#include <span>

#include "common/vec.h"

namespace infra {

/// Derivatives of the share of a hemisphere (0..1, cosine-weighted) that a shape fills, with respect to where
/// it is seen from; x and y lie in the surface.
struct ShareDerivatives {
    double x = 0, y = 0;            ///< per scene unit
    double xx = 0, xy = 0, yy = 0;  ///< per its square

    void add(const ShareDerivatives& other, double factor);
};

/// What an edge from a to b, in the frame of the surface (z: normal), adds for a polygon that lies to its
/// left as seen along -z; 0 for an edge that is seen end on.
ShareDerivatives edge_derivatives(const Vec3& a, const Vec3& b);

/// Where a ray of the hemisphere ended.
struct MeshCorner {
    Vec3 place;       ///< in the frame of the surface, from its point
    double nearness;  ///< 1 / distance of the nearest thing seen in this direction
    double value;     ///< radiance over the mean radiance of the hemisphere
};

/// The irradiance of the mesh alone, over that of the whole hemisphere, has the derivatives inner + rim. With
/// inner + skirt the mesh goes on from its rim straight down to the horizon: truer, and without any change
/// where all values are the same.
struct MeshDerivatives {
    ShareDerivatives inner;
    ShareDerivatives rim;
    ShareDerivatives skirt;
    ShareDerivatives shape;  ///< inner + rim if all values were 1: depends on distances alone
};

/// shape: n x n corners, (i, j) at i * n + j, x grows with i and y with j; n is 2 or more
MeshDerivatives mesh_derivatives(int n, std::span<const MeshCorner> corners);

/// Directions in the plane along which the irradiance bends most and least.
struct Bend {
    double cosine = 1, sine = 0;        ///< of the angle from x to the direction of the strongest
    double strongest = 0, weakest = 0;  ///< absolute second derivatives
};
Bend bend(const ShareDerivatives& second);

}  // namespace infra
