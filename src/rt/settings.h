// What the options of rpict and rtrace say about light transport. Field comments name RADIANCE's option; the
// two programs start from different defaults (render_options.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rt/split/split_settings.h"

namespace infra {

/// Modifiers named by -ai/-aI (include) or -ae/-aE (exclude).
struct NameFilter {
    enum class Mode { none, include, exclude } mode = Mode::none;
    std::vector<std::string> names;
};

/// More rays than anyone asks for at one hit: keeps products of counts within an int.
inline constexpr int most_samples = 1 << 24;

/// -ap: a photon map to use.
struct PhotonMapRequest {
    std::string file;
    int fewest = 0, most = 0;  ///< photons that an estimate takes; they differ to compensate bias; 0: usual
};

struct RenderSettings {
    // Direct light
    double source_jitter = 0.0;       ///< -dj: share of a source's area over which samples are spread, 0..1
    double source_size_ratio = 0.25;  ///< -ds: largest size/distance of a part of a source; 0 never divides
    double shadow_threshold = 0.05;   ///< -dt: sources that could add less than this share are not tested
    double shadow_certainty = 0.5;    ///< -dc
    bool sources_visible = true;      ///< -dv
    int direct_relays = 1;            ///< -dr: mirrors on the way from a source, 0..
    int direct_pretest = 512;  ///< -dp: rays to see whether a virtual source is worth keeping; 0: keep all

    // Specular lobes
    double specular_threshold = 0.15;  ///< -st: rough lobes of this share or less join the ambient term
    double specular_samples = 1.0;     ///< -ss: below 1 less spread, above 1.5 that many rays

    // Diffuse interreflection
    float ambient_value[3] = {0, 0, 0};  ///< -av: radiance assumed where the bounces end
    int ambient_value_weight = 0;        ///< -aw: weight of -av among the cached values, 0: it stays as it is
    int ambient_bounces = 0;             ///< -ab
    double ambient_accuracy = 0;         ///< -aa: error of interpolated irradiance, 0: none is interpolated
    int ambient_resolution = 64;  ///< -ar: scene size over the least distance of cached values; 0: no limit
    std::string ambient_file;     ///< -af: cached values from and for other runs; empty: none
    int ambient_divisions = 512;  ///< -ad: rays of a hemisphere
    int ambient_super_samples = 128;  ///< -as: extra rays where neighbours differ
    NameFilter ambient_filter;        ///< -ai -ae
    double guided_samples =
        0;  ///< -gs: rays of a hemisphere or lobe sent to what is bright (guiding/guide.h)

    // Photon maps
    std::vector<PhotonMapRequest> photon_maps;  ///< -ap
    double photon_radius = 0;  ///< -am: distance within which photons are looked for; 0: by their density

    // Participating medium everywhere but where a mist says otherwise
    float extinction[3] = {0, 0, 0};         ///< -me: per scene unit
    float scattering_albedo[3] = {0, 0, 0};  ///< -ma
    double scattering_eccentricity = 0;      ///< -mg: Henyey-Greenstein's g
    double medium_step = 0;                  ///< -ms: distance between samples of scattered light; 0: none

    // Air
    std::string air_path;  ///< -mp: file of the air along camera rays (common/data/air_path.h); empty: none

    // Limits
    int max_reflections = 7;   ///< -lr: negative turns Russian roulette on below min_weight, 0: no limit
    double min_weight = 1e-4;  ///< -lw

    std::optional<SplitSettings> split;  ///< -split: radiance told apart by where it comes from

    std::uint64_t seed = 0;  ///< -seed: names the random streams of a run

    bool back_faces_visible = true;  ///< -bv
    bool irradiance = false;         ///< -i: the first surface met is white Lambertian times pi
};

}  // namespace infra
