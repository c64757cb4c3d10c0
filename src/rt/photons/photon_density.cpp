#include "rt/photons/photon_density.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "rt/photons/bias_compensation.h"
#include "rt/volume/henyey_greenstein.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t fewest_photons = 2;

void add_flux(PhotonColor& sum, const Rgbe& flux, double factor) {
    if (flux[3] == 0) return;
    constexpr int exponent_bias = 136;
    const double scale = factor * std::bit_cast<double>(std::uint64_t{1023u + flux[3] - exponent_bias} << 52);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += (flux[c] + 0.5) * scale;
}

PhotonColor scaled(const PhotonColor& color, double factor) {
    return {color[0] * factor, color[1] * factor, color[2] * factor};
}

/// Square of the mean of two distances.
double between2(float a2, float b2) {
    const double mean = 0.5 * (std::sqrt(double{a2}) + std::sqrt(double{b2}));
    return mean * mean;
}

/// Square of the radius that all but the farthest photon stand for.
double edge2(std::span<const FoundPhoton> heap, float radius2) {
    const float second = heap.size() > 2 ? std::max(heap[1].distance2, heap[2].distance2) : heap[1].distance2;
    return between2(radius2, second);
}

}  // namespace

PhotonColor PhotonDensity::surface(const PhotonSource& source, const Vec3& point, const Vec3& normal,
                                   bool only_caustic, RandomStream& random) {
    const PhotonQuery query = PhotonQuery(point).facing(normal).caustic(only_caustic);
    if (source.photons.kind() == PhotonKind::precomputed) return nearest(source, query);
    search_.find(source.photons, query, static_cast<std::size_t>(source.most) + 1, source.limit2);
    const std::span<const FoundPhoton> found = search_.found();
    if (found.size() < fewest_photons) return {0, 0, 0};
    if (source.fewest < source.most) return compensated(source, random);
    PhotonColor flux{0, 0, 0};
    for (const FoundPhoton& photon : found.subspan(1))
        add_flux(flux, source.photons.attributes(photon.place).flux(), 1);
    const double radius2 = edge2(found, search_.radius2());
    if (!(radius2 > 0)) return {0, 0, 0};
    return scaled(flux, 1 / (pi * pi * radius2));
}

PhotonColor PhotonDensity::nearest(const PhotonSource& source, const PhotonQuery& query) {
    PhotonColor radiance{0, 0, 0};
    search_.find(source.photons, query, 1, source.limit2);
    for (const FoundPhoton& photon : search_.found())
        add_flux(radiance, source.photons.attributes(photon.place).flux(), 1);
    return radiance;
}

PhotonColor PhotonDensity::compensated(const PhotonSource& source, RandomStream& random) {
    const std::span<FoundPhoton> found = search_.found();
    std::sort(found.begin(), found.end(),
              [](const FoundPhoton& a, const FoundPhoton& b) { return a.distance2 < b.distance2; });
    flux_.resize(found.size());
    PhotonColor sum{0, 0, 0};
    for (std::size_t i = 0; i < found.size(); ++i) {
        add_flux(sum, source.photons.attributes(found[i].place).flux(), 1);
        flux_[i] = sum;
    }
    const auto per_radius2 = [&](std::size_t count) {
        const double radius2 = between2(found[count - 1].distance2, found[count].distance2);
        return radius2 > 0 ? scaled(flux_[count - 1], 1 / radius2) : PhotonColor{0, 0, 0};
    };
    const std::size_t most = std::min(static_cast<std::size_t>(source.most), found.size() - 1);
    const std::size_t fewest = std::min(static_cast<std::size_t>(source.fewest), most);
    BiasCompensation compensation;
    for (std::size_t count = 1; count <= fewest; ++count) compensation.add(count, per_radius2(count));
    return scaled(compensation.choose(fewest, most, per_radius2, random), 1 / (pi * pi));
}

PhotonColor PhotonDensity::volume(const PhotonSource& source, const Vec3& point, const Vec3& view,
                                  double eccentricity) {
    search_.find(source.photons, PhotonQuery(point), static_cast<std::size_t>(source.most) + 1,
                 source.limit2);
    const std::span<const FoundPhoton> found = search_.found();
    if (found.size() < fewest_photons) return {0, 0, 0};
    PhotonColor scattered{0, 0, 0};
    for (const FoundPhoton& photon : found.subspan(1)) {
        const PhotonMap::Attributes attributes = source.photons.attributes(photon.place);
        double cosine = 0;
        for (int i = 0; i < 3; ++i) cosine -= view[i] * attributes.direction(i) / 127;
        add_flux(scattered, attributes.flux(), henyey_greenstein(eccentricity, cosine));
    }
    const double radius2 = edge2(found, search_.radius2());
    if (!(radius2 > 0)) return {0, 0, 0};
    return scaled(scattered, 3 / (4 * pi * radius2 * std::sqrt(radius2)));
}

}  // namespace infra
