// What is passed around while a scene is compiled: what grows, and what its parts share.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "cal/library.h"
#include "common/spectra/channels.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/scene_part.h"
#include "rt/compile/surface_table.h"
#include "rt/compile/table_cache.h"
#include "rt/geometry/geometry.h"
#include "rt/settings.h"

namespace infra {

struct CompileContext {
    const RenderSettings& settings;
    const Channels& channels;

    std::deque<ScenePart>& parts;
    SurfaceTable& surfaces;
    std::vector<std::unique_ptr<Modifier>>& modifiers;
    std::vector<std::unique_ptr<Geometry>>& contents;  ///< of instances
    std::vector<std::string>& warnings;

    cal::Library functions;
    TableCache tables;
    DataCache data;
};

}  // namespace infra
