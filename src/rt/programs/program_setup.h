// What rpict and rtrace do alike before and after tracing rays.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rt/compile/compiled_scene.h"
#include "rt/programs/render_options.h"
#include "rt/tracer.h"
#include "scene/octree.h"
#include "scene/warnings.h"

namespace infra {

struct LoadedScene {
    std::shared_ptr<const CompiledScene> scene;
    std::vector<std::string> header;  ///< of the octree: how it came about
    std::vector<std::string> files;   ///< scene files and commands that the octree was made from
    Cube cube;                        ///< around the scene
};

/// Reads and compiles an octree: a file, "!command", or "" for the standard input. The scene's own warnings,
/// which are about shading, stay the caller's.
LoadedScene load_scene(const std::string& octree, const RenderOptions& options, const WarningSink& warn);

/// The command line and software that a picture or table was made with, after what the octree says about
/// itself.
std::vector<std::string> header_lines(const std::vector<std::string>& octree_header,
                                      const std::string& command_line);

/// Appends all messages to a file from now on, opened by the command line; "" does nothing.
///   throws  Error when it cannot be opened
void redirect_messages(const std::string& path, const std::string& command_line);

/// Warnings as the program's options want them.
WarningSink warning_sink(const std::string& program, const RenderOptions& options);

/// What tracers have done, and things that went wrong, and how often.
struct TracerReport {
    RayCounts rays;
    std::uint64_t bad_values = 0;  ///< radiances that were not finite
    std::uint64_t bad_temperatures = 0;
    std::uint64_t function_faults = 0;  ///< domain errors in functions
    std::string last_function_fault;

    void add(Tracer& tracer);
    void add(const TracerReport& more);
    /// Warns of what went wrong.
    void warn_of_faults(const WarningSink& warn) const;
    /// With -stats, says on stderr what was done.
    void print_statistics(const std::string& program, const RenderOptions& options,
                          const IrradianceCache* cache) const;
};

}  // namespace infra
