// Primitives in binary, as frozen octrees (.oct) and meshes (.rtm) hold them: names of types, then one record
// each.
#pragma once

#include "scene/byte_reader.h"
#include "scene/byte_writer.h"
#include "scene/scene.h"

namespace infra {

/// Adds the primitives to an empty scene. id_size: bytes of a primitive's number in this file. Their place is
/// the file without a line.
///   throws  Error for unknown types, modifiers not defined before, and truncated or senseless data
void read_scene_section(ByteReader& in, Scene& scene, int id_size);

/// Bytes of a primitive's number in the files that we (and RADIANCE) write.
inline constexpr int written_id_size = 4;

/// Names RADIANCE's 59 types in its order, so that its programs can read the file, and ours behind them if
/// used.
///   throws  Error for a primitive with more than 32767 arguments of one sort, which the format cannot hold
void write_scene_section(ByteWriter& out, const Scene& scene);
/// The same for the first `count` primitives.
void write_scene_section(ByteWriter& out, const Scene& scene, PrimitiveId count);

}  // namespace infra
