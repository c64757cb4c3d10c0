#include "rt/programs/ambient_setup.h"

#include "common/format.h"
#include "common/version.h"

namespace infra {
namespace {

/// The parameters that values depend on, as the command line of the program that computes them.
std::string parameter_line(const RenderSettings& s, const Channels& channels, const std::string& program,
                           const std::string& octree) {
    const auto& av = s.ambient_value;
    std::string line = program;
    line += formatted(" -av %g %g %g -aw %d -ab %d -aa %g", double(av[0]), double(av[1]), double(av[2]),
                      s.ambient_value_weight, s.ambient_bounces, s.ambient_accuracy);
    line += formatted(" -ad %d -as %d -ar %d", s.ambient_divisions, s.ambient_super_samples,
                      s.ambient_resolution);
    line += formatted(" -dr %d -ds %g -dt %g -dc %g", s.direct_relays, s.source_size_ratio,
                      s.shadow_threshold, s.shadow_certainty);
    line += formatted(" -ss %g -st %g -lr %d -lw %g", s.specular_samples, s.specular_threshold,
                      s.max_reflections, s.min_weight);
    line += formatted(" -cw %g %g -cs %d", channels.shortest_nm(), channels.longest_nm(), channels.count());
    return octree.empty() ? line : line + " " + octree;
}

}  // namespace

std::unique_ptr<IrradianceCache> open_irradiance_cache(const LoadedScene& loaded,
                                                       const RenderOptions& options,
                                                       const std::string& program, const std::string& octree,
                                                       const WarningSink& warn) {
    constexpr double finest = 1e-6;
    const RenderSettings& settings = options.settings;
    const std::string& path = settings.ambient_file;
    if (settings.ambient_accuracy <= finest) {
        if (!path.empty()) warn("zero ambient accuracy so \"" + path + "\" not opened");
        return nullptr;
    }
    const Channels& channels = loaded.scene->channels();
    auto cache = std::make_unique<IrradianceCache>(loaded.cube, channels.count(), settings.ambient_accuracy,
                                                   settings.ambient_resolution);
    if (!path.empty()) {
        const std::vector<std::string> lines = {parameter_line(settings, channels, program, octree),
                                                std::string("SOFTWARE= ") + version_string()};
        cache->share_with(std::make_unique<AmbientFile>(path, channels, lines, warn));
    }
    return cache;
}

}  // namespace infra
