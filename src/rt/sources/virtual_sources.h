// Virtual light sources: the images of light sources in mirrors and prisms, and the images of these.
#pragma once

#include <string>
#include <vector>

#include "rt/compile/compiled_scene.h"
#include "rt/sources/light_relay.h"

namespace infra {

/// The flat surfaces that make images; a warning for each material of them that others wear. To be called
/// while the scene still has its surfaces' arguments.
std::vector<RelaySurface> find_relays(const Scene& scene, const SurfaceTable& surfaces,
                                      std::vector<std::string>& warnings);

/// Appends the images of all sources, up to `settings.direct_relays` one after the other, that light can
/// reach by what is known of the positions (-dp 0) and by rays sent out to see (-dp). Their numbers begin
/// after those of the sources so far. `scene` is complete but for them.
void add_virtual_sources(const CompiledScene& scene, const RenderSettings& settings,
                         const std::vector<RelaySurface>& relays, std::vector<LightSource>& sources);

}  // namespace infra
