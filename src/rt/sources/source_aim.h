// Rays aimed at a place of a light source.
#pragma once

#include "common/random.h"
#include "rt/sources/source_parts.h"

namespace infra {

struct SourceAim {
    Vec3 direction{0};  ///< unit
    double omega = 0;   ///< solid angle [sr] that the place stands for, from where the ray starts
};

/// Whether a source is certain to give no light at a point: a glow that is too far away.
bool is_out_of_reach(const LightSource& source, const Vec3& point);

/// A place on a part of a source: its middle, or spread over a share `jitter` of it.
///   alone  the source has no other part
Vec3 place_on(const LightSource& source, const Part& part, bool alone, double jitter, RandomStream& random);

/// Aims at a place. share: of the source that the place stands for. False where the source does not shine.
bool aim_at(const LightSource& source, const Vec3& from, const Vec3& place, double share, SourceAim& aim);

}  // namespace infra
