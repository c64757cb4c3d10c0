// A BSDF at one hit: its coordinates there, what the viewer's direction says, and the colours of a rendering.
#pragma once

#include "bsdf/bsdf.h"
#include "common/random.h"
#include "common/spectra/channels.h"
#include "common/spectra/spectrum.h"

namespace infra {

/// The share that goes straight through a surface full of holes, and what the transmission is around it.
struct Aperture {
    Spectrum through;   ///< coefficient of what lies straight behind
    Spectrum surround;  ///< f [1/sr] near that direction without it

    explicit Aperture(int channels) : through(channels), surround(channels) {}
    bool open() const { return through.maximum() > 0; }
};

/// Lives on the stack of the shading that it belongs to.
struct BsdfHit {
    const Bsdf& bsdf;
    const Channels& channels;
    RandomStream& random;
    double sharpness;  ///< -ss: below 1 less spread

    bool front = true;                        ///< is seen
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< the BSDF's axes in the scene; z is the normal of the front
    Vec3 viewer{0, 0, 1};                     ///< in these axes
    Spectrum pattern;
    Aperture aperture;

    BsdfHit(const Bsdf& table, const Channels& c, RandomStream& stream, double specular_samples)
        : bsdf(table),
          channels(c),
          random(stream),
          sharpness(specular_samples),
          pattern(c.count(), 1.0f),
          aperture(c.count()) {}

    /// Lays the axes: y is `up` as far as it lies in the surface. False if there is no such direction.
    bool orient(const Vec3& normal, const Vec3& up, const Vec3& to_viewer);

    Vec3 to_local(const Vec3& d) const { return {dot(d, x), dot(d, y), dot(d, z)}; }
    Vec3 to_scene(const Vec3& d) const { return x * d.x + y * d.y + z * d.z; }

    const ScatterTable* reflection() const { return bsdf.reflection(front); }
    const ScatterTable* transmission() const { return bsdf.transmission(front); }

    /// The viewer's direction moved at random over a patch [sr], which hides the edges between patches.
    Vec3 jittered_viewer(double projected_solid_angle) const;

    Spectrum spectrum_of(const Xyz& color) const;
    /// f [1/sr] of a table's entry for a pair.
    Spectrum spectrum_of(const ScatterTable& table, const ScatterEntry& entry, const Vec3& in,
                         const Vec3& out) const;
};

}  // namespace infra
