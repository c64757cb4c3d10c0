// The geometry of an isotropic reflection seen from its half vector: h bisects incident and reflected
// direction.
#pragma once

namespace infra {

/// All angles in radians.
struct HalfVector {
    double theta_h;        ///< between h and the surface normal, 0..pi/2; 0 in the mirror direction
    double theta_d;        ///< between h and either direction, 0..pi/2: a facet's angle of incidence
    double cos_imbalance;  ///< (cos theta_r - cos theta_i) / 2 = sin theta_h sin theta_d cos phi_d;
                           ///< changes sign when the directions are exchanged
    double phi_d;          ///< azimuth of the incident direction about h, 0..pi; 0 where it is not defined
};

/// phi is the azimuth of the reflected minus that of the incident direction; its sign does not matter.
/// source: Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation", EGWR 1998.
HalfVector half_vector(double theta_i, double phi, double theta_r);

}  // namespace infra
