// A surface that is sampled directly because it gives light: light, illum, spotlight, and glow or emissive
// within their radius; or a distant source; or the image of any of these in a mirror or prism.
#pragma once

#include "common/spectra/spectrum.h"
#include "common/vec.h"
#include "rt/modifier.h"

namespace infra {

struct SpotBeam {
    Vec3 axis{0};  ///< unit
    double solid_angle = 0;
    double focal_length = 0;
    /// Whether light that leaves towards -direction misses the beam.
    bool misses(const Vec3& direction) const;
};

/// The surface that a virtual source is seen in, as a disk.
struct RelayDisk {
    Vec3 center{0};
    double radius = 0;
    /// Whether a ray passes beside it. direction: unit.
    bool missed_by(const Vec3& origin, const Vec3& direction) const {
        const Vec3 offset = center - origin;
        const double along = dot(offset, direction);
        return dot(offset, offset) - along * along > radius * radius;
    }
};

struct LightSource {
    enum class Extent {
        flat,      ///< polygon or ring: area elements along two axes
        cylinder,  ///< elements along the axis
        sphere,
        distant,  ///< a disk at infinity
    };

    int surface = -1;  ///< of a virtual source the mirror or prism
    Extent extent = Extent::flat;
    bool round = false;    ///< its samples are kept within a circle or ball
    bool skip = false;     ///< never sampled, only met by chance
    bool is_glow = false;  ///< gives light only nearer than `reach`
    double reach = 0;
    bool is_spot = false;
    SpotBeam beam;

    Vec3 center{0};  ///< distant: unit direction towards it
    Vec3 normal{0};
    double radius = 0;        ///< of the surrounding sphere
    double least_cosine = 1;  ///< distant: of a direction within the disk and `center`
    double size = 0;          ///< area, cylinder: the greatest projected area; distant: solid angle [sr]
    Vec3 half_axis[3] = {Vec3{0}, Vec3{0}, Vec3{0}};
    const Modifier* modifier = nullptr;  ///< of the surface: what gives the radiance
    /// Of its front, if it is the same everywhere and in all directions; nullptr: the modifier knows.
    const Spectrum* even_radiance = nullptr;
    bool passes_unseen = false;  ///< an illum without another material, seen through when not aimed at
    bool is_weak = false;        ///< illum or glow: an illum in the way blocks it

    // Virtual sources: sources/virtual_sources.cpp
    int parent = -1;  ///< the source that this is the image of, -1: a real one
    int image = 0;    ///< which of the images that the surface makes of it (prism2 makes two)
    RelayDisk disk;

    bool is_virtual() const { return parent >= 0; }
    bool distant() const { return extent == Extent::distant; }
    /// Whether a ray aimed at this source that meets the surface has reached what shines by itself.
    bool shines_from(int met_surface) const { return surface == met_surface && !is_virtual(); }
};

}  // namespace infra
