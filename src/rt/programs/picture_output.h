// What rpict writes: the picture as colors or spectra, its header, its description, the distances.
#pragma once

#include <string>
#include <vector>

#include "rt/programs/pixel_tracer.h"
#include "rt/programs/rpict_options.h"

namespace infra {

/// Whether the picture is written as colors, not one value a channel: RADIANCE's pictures are unless -co or
/// the name's .hsr asks for spectra, OpenEXR only by -pXYZ and -pc.
bool writes_colors(const RpictOptions& options);

/// Fails now rather than after hours of work if a file cannot be written; those of a sequence are left alone.
void check_writable(const RpictOptions& options);

/// Writes the files that the options name, or the picture to the standard output. No date is among its lines:
/// the same command gives the same file.
///   first_lines   of the header: how the picture came about
///   command_line  rpict's
///   finished_rows  replace those at the top, if there are any: of a picture that others began
void write_frame(Frame frame, const Picture& finished_rows, const CompiledScene& scene,
                 const RpictOptions& options, const std::vector<std::string>& first_lines,
                 const std::string& command_line);

}  // namespace infra
