#include <algorithm>
#include <unordered_set>

#include "rt/shapes/polygon.h"
#include "rt/sources/virtual_sources.h"

namespace infra {
namespace {

constexpr double slack = 1e-6;  // widens a disk so that rounding leaves no point of the surface outside

Vec3 vec(std::span<const double> n, std::size_t first) { return {n[first], n[first + 1], n[first + 2]}; }

bool set_polygon(std::span<const double> corners, RelaySurface& relay) {
    const auto numbers = distinct_vertices(corners);
    const std::size_t count = numbers.size() / 3;
    const PolygonPlane plane = polygon_plane(numbers);
    if (plane.area == 0) return false;
    relay.normal = plane.normal;
    relay.offset = plane.offset;
    Vec3& center = relay.disk.center;
    for (std::size_t i = 0; i < count; ++i) center += vec(numbers, 3 * i);
    center /= static_cast<double>(count);
    center += plane.normal * (plane.offset - dot(center, plane.normal));
    for (std::size_t i = 0; i < count; ++i)
        relay.disk.radius = std::max(relay.disk.radius, length(vec(numbers, 3 * i) - center));
    return true;
}

bool set_ring(std::span<const double> numbers, RelaySurface& relay) {
    const Vec3 axis = vec(numbers, 3);
    if (!(length(axis) > 0)) return false;
    relay.normal = normalize(axis);
    relay.disk = {vec(numbers, 0), std::max(numbers[6], numbers[7])};
    relay.offset = dot(relay.normal, relay.disk.center);
    return true;
}

bool set_plane(const Scene& scene, PrimitiveId id, RelaySurface& relay) {
    const bool is_ring = scene.type(id) == PrimitiveType::ring;
    const bool has_area = is_ring ? set_ring(scene.reals(id), relay) : set_polygon(scene.reals(id), relay);
    return has_area && relay.disk.radius > same_place;
}

}  // namespace

std::vector<RelaySurface> find_relays(const Scene& scene, const SurfaceTable& surfaces,
                                      std::vector<std::string>& warnings) {
    std::vector<RelaySurface> relays;
    std::unordered_set<const LightRelay*> warned;
    for (int i = 0; i < static_cast<int>(surfaces.surfaces.size()); ++i) {
        const MaterialTraits* material = surfaces.finish(i).material;
        if (!material || !material->relay) continue;
        const PrimitiveId id = surfaces[i].primitive;
        RelaySurface relay{.surface = i, .relay = material->relay};
        if (scene.type(id) == PrimitiveType::polygon || scene.type(id) == PrimitiveType::ring) {
            if (!set_plane(scene, id, relay)) continue;
            relay.disk.radius *= 1 + slack;
            relays.push_back(relay);
        } else if (warned.insert(material->relay).second) {
            warnings.push_back(
                scene
                    .error(
                        id, "light sources are not seen in this " + std::string(name(scene.type(id))),
                        "\"" + std::string(material->name) + "\" relays light from polygons and rings only")
                    .what());
        }
    }
    return relays;
}

}  // namespace infra
