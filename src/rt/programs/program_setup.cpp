#include "rt/programs/program_setup.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "common/error.h"
#include "common/format.h"
#include "common/version.h"
#include "rt/ambient/irradiance_cache.h"
#include "scene/octree_file.h"

namespace infra {
namespace {

/// Photons of another scene than this would be wrong without a sign of it.
void check_photons_are_newer(const std::string& octree, const RenderSettings& settings) {
    struct stat scene = {}, map = {};
    if (octree.empty() || stat(octree.c_str(), &scene) != 0) return;
    for (const PhotonMapRequest& request : settings.photon_maps)
        if (stat(request.file.c_str(), &map) == 0 && scene.st_mtime > map.st_mtime)
            throw Error(Location{request.file}, "this photon map is older than the octree",
                        "make it again, or touch it if the scene has not changed");
}

}  // namespace

LoadedScene load_scene(const std::string& octree, const RenderOptions& options, const WarningSink& warn) {
    check_photons_are_newer(octree, options.settings);
    OctreeFile file = load_octree(octree, warn);
    LoadedScene loaded;
    loaded.header = std::move(file.header);
    loaded.files = std::move(file.scene_files);
    loaded.cube = file.cube;
    loaded.scene = CompiledScene::compile(std::move(file.scene), options.settings, options.channels(),
                                          options.definitions);
    return loaded;
}

std::vector<std::string> header_lines(const std::vector<std::string>& octree_header,
                                      const std::string& command_line) {
    std::vector<std::string> lines;
    for (const std::string& line : octree_header)
        if (!line.starts_with("#?")) lines.push_back(line);
    lines.push_back(command_line);
    lines.push_back(std::string("SOFTWARE= ") + version_string());
    return lines;
}

void redirect_messages(const std::string& path, const std::string& command_line) {
    if (path.empty()) return;
    // Opened first by itself, so that a failure can still be reported.
    std::FILE* const test = std::fopen(path.c_str(), "a");
    if (!test || !std::freopen(path.c_str(), "a", stderr))
        throw Error("cannot open error file \"" + path + "\": " + std::strerror(errno), {}, Severity::system);
    std::fclose(test);
    std::fprintf(stderr, "**************\n*** %s\n", command_line.c_str());
    std::fflush(stderr);
}

WarningSink warning_sink(const std::string& program, const RenderOptions& options) {
    return options.warnings ? print_warnings(program) : no_warnings();
}

void TracerReport::add(Tracer& tracer) {
    const std::uint64_t faults = tracer.evaluator().fault_count();
    add({.rays = tracer.rays(),
         .bad_values = tracer.bad_values(),
         .bad_temperatures = tracer.bad_temperatures(),
         .function_faults = faults,
         .last_function_fault = faults > 0 ? tracer.evaluator().last_fault() : std::string()});
}

void TracerReport::add(const TracerReport& more) {
    rays.add(more.rays);
    bad_values += more.bad_values;
    bad_temperatures += more.bad_temperatures;
    function_faults += more.function_faults;
    if (more.function_faults > 0) last_function_fault = more.last_function_fault;
}

void TracerReport::warn_of_faults(const WarningSink& warn) const {
    if (bad_values > 0)
        warn(formatted("%llu radiances were not finite and count as 0",
                       static_cast<unsigned long long>(bad_values)));
    if (bad_temperatures > 0)
        warn(formatted(
            "%llu temperatures of thermal surfaces were not above 0 K, and nothing is emitted there",
            static_cast<unsigned long long>(bad_temperatures)));
    if (function_faults > 0)
        warn(
            formatted("%llu function values were undefined, and their patterns, textures or mixtures left "
                      "out; one of them: %s",
                      static_cast<unsigned long long>(function_faults), last_function_fault.c_str()));
}

void TracerReport::print_statistics(const std::string& program, const RenderOptions& options,
                                    const IrradianceCache* cache) const {
    if (!options.statistics) return;
    struct Sort {
        unsigned kinds;
        const char* name;
    };
    constexpr Sort sorts[] = {{primary_ray, "primary"},   {shadow_rays, "shadow"},
                              {ambient_rays, "ambient"},  {lobe_rays, "rough specular"},
                              {mirrored_ray, "mirrored"}, {through_ray, "through"}};
    std::string text = formatted("%llu rays", static_cast<unsigned long long>(rays.total()));
    const char* before = ": ";
    for (const Sort& sort : sorts) {
        const std::uint64_t count = rays.of_kinds(sort.kinds);
        if (count == 0) continue;
        text += formatted("%s%llu %s", before, static_cast<unsigned long long>(count), sort.name);
        before = ", ";
    }
    if (cache) text += formatted("; %zu values in the irradiance cache", cache->size());
    std::fprintf(stderr, "%s: %s\n", program.c_str(), text.c_str());
}

}  // namespace infra
