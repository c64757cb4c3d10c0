// What a transform does to one primitive.
#pragma once

#include "scene/rad_parser.h"
#include "scene/xform/settings.h"

namespace infra::xform {

/// Moves positions and directions, scales lengths (also glow's and emissive's radius, mist's extinction and
/// the transmissivity of dielectrics), turns surfaces inside out for -I, and hands the transform on to
/// primitives that keep it among their string arguments. Surfaces get the prefix and modifier of the
/// settings.
///   throws  Error at `where` when the arguments it must change are not of the right number
void apply(const Settings& settings, ParsedPrimitive& primitive, const Location& where);

}  // namespace infra::xform
