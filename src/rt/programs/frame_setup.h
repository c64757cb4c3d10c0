// What the options make of one picture's view: the camera, the samples, the sources that its rays pass.
#pragma once

#include <optional>
#include <vector>

#include "rt/programs/frame_painter.h"
#include "rt/programs/rpict_options.h"
#include "rt/programs/small_sources.h"

namespace infra {

/// Wider spacings of samples are reduced to this.
inline constexpr int widest_spacing = 16;

FrameOptions frame_options(const RpictOptions& options, int width, int height, int first_row,
                           IrradianceCache* cache);

/// Both views are set up. previous: of the picture before, if motion is to be blurred
Camera camera_of(const RpictOptions& options, const View& view, const std::optional<View>& previous);

/// Finds the small sources of a picture and makes the camera's rays pass them. None where the picture is
/// blurred, or a medium lies before them all.
std::vector<SmallSource> pass_small_sources(const CompiledScene& scene, const RpictOptions& options,
                                            const FrameOptions& size, Camera& camera);

}  // namespace infra
