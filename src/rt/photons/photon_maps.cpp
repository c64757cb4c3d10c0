#include "rt/photons/photon_maps.h"

#include "common/error.h"
#include "common/format.h"
#include "common/raypath.h"
#include "rt/photons/photon_file.h"

namespace infra {
namespace {

constexpr int usual_count = 40;
/// Search radius without -am, as RADIANCE's: squared, so many times the photons looked for over those there
/// are, in mean square distances of photons from their middle.
constexpr double usual_limit = 100;

std::string warning(const PhotonMapRequest& request, const std::string& text) {
    return request.file + ": " + text;
}

/// How many photons an estimate takes from a map, as asked for as far as it goes.
void set_counts(PhotonSource& source, const PhotonMapRequest& request, std::vector<std::string>& warnings) {
    const PhotonKind kind = source.photons.kind();
    source.fewest = request.fewest;
    source.most = request.most;
    if (kind == PhotonKind::precomputed) {
        if (request.most > 1)
            warnings.push_back(warning(
                request, "a precomputed map is looked up one photon at a time, its bandwidth ignored"));
        source.fewest = source.most = 1;
        return;
    }
    if (request.most == 0) {
        warnings.push_back(
            warning(request, formatted("no bandwidth given, %d photons are looked up", usual_count)));
        source.fewest = source.most = usual_count;
    }
    if (kind == PhotonKind::volume && source.fewest < source.most)
        throw Error(Location{request.file}, "bias compensation is not available for a volume map",
                    "give one bandwidth");
    const std::size_t size = source.photons.size();
    if (static_cast<std::size_t>(source.most) > size) {
        warnings.push_back(
            warning(request, formatted("only %zu photons for a bandwidth of %d", size, source.most)));
        source.fewest = source.most = static_cast<int>(size - 1);  // one more is looked up
    }
}

float limit_for(const PhotonSource& source, double radius) {
    const double spread2 = source.photons.spread2();
    if (source.photons.kind() == PhotonKind::precomputed) return static_cast<float>(spread2);
    if (radius > 0) return static_cast<float>(radius * radius);
    return static_cast<float>(usual_limit * (source.most + 1) * spread2 /
                              static_cast<double>(source.photons.size()));
}

}  // namespace

PhotonMaps::PhotonMaps(const RenderSettings& settings, std::vector<std::string>& warnings) {
    for (const PhotonMapRequest& request : settings.photon_maps) {
        PhotonSource source{read_photon_map(request.file), 0, 0, 0};
        set_counts(source, request, warnings);
        source.limit2 = limit_for(source, settings.photon_radius);
        auto& slot = sources_[static_cast<std::size_t>(source.photons.kind())];
        if (slot)
            warnings.push_back(warning(
                request, "replaces another " + std::string(name_of(source.photons.kind())) + " photon map"));
        slot.emplace(std::move(source));
    }
    covers_transmitted_light_ = caustic() || (of(PhotonKind::global) && settings.ambient_bounces < 0);
}

const PhotonSource* PhotonMaps::indirect() const {
    for (const PhotonKind kind : {PhotonKind::contribution, PhotonKind::precomputed, PhotonKind::global})
        if (const PhotonSource* source = of(kind)) return source;
    return nullptr;
}

const PhotonSource* PhotonMaps::caustic() const {
    const PhotonSource* const contribution = of(PhotonKind::contribution);
    return contribution ? contribution : of(PhotonKind::caustic);
}

}  // namespace infra
