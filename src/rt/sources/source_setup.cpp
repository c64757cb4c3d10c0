#include "rt/sources/source_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/ray.h"
#include "rt/shapes/polygon.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 vec(std::span<const double> n, std::size_t first) { return {n[first], n[first + 1], n[first + 2]}; }

// Square of the same area as a flat source of any outline, along the axes that RADIANCE takes when nothing is
// drawn at random (-u-): the first lies across the last of x, y, z that is not near the normal.
void set_square_axes(LightSource& source) {
    constexpr double near = 0.6;  // cosine
    int other = 2;
    while (other > 0 && std::fabs(source.normal[other]) >= near) --other;
    Vec3 across{0};
    across[other] = 1;
    source.half_axis[0] = normalize(cross(across, source.normal)) * (0.5 * std::sqrt(source.size));
    source.half_axis[1] = cross(source.normal, source.half_axis[0]);
}

double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
    return length(cross(p - a, b - a)) / length(b - a);
}

void set_polygon(const Scene& scene, PrimitiveId id, LightSource& source,
                 std::vector<std::string>& warnings) {
    const auto numbers = distinct_vertices(scene.reals(id));
    const std::size_t count = numbers.size() / 3;
    const PolygonPlane plane = polygon_plane(numbers);
    if (plane.area == 0) throw scene.error(id, "light source has no area");
    source.extent = LightSource::Extent::flat;
    source.normal = plane.normal;
    source.size = plane.area;
    for (std::size_t i = 0; i < count; ++i) source.center += vec(numbers, 3 * i);
    source.center /= static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i)
        source.radius = std::max(source.radius, length(vec(numbers, 3 * i) - source.center));

    const Vec3 a = vec(numbers, 0), b = vec(numbers, 3), last = vec(numbers, 3 * (count - 1));
    if (count == 4) {  // taken for a parallelogram
        source.half_axis[0] = (b - a) * 0.5;
        source.half_axis[1] = (last - a) * 0.5;
    } else if (count == 3) {  // a square in the inscribed circle, along the nearest edge
        const Vec3 corner[3] = {a, b, last};
        int nearest = 2;
        double inscribed = distance_to_line(source.center, corner[2], corner[0]);
        for (int i = 0; i < 2; ++i) {
            const double d = distance_to_line(source.center, corner[i], corner[i + 1]);
            if (d < inscribed) {
                inscribed = d;
                nearest = i;
            }
        }
        if (inscribed * inscribed < 0.08 * plane.area)
            warnings.push_back(scene.error(id, "triangular light source with poor aspect").what());
        source.half_axis[0] = normalize(corner[(nearest + 1) % 3] - corner[nearest]) * inscribed;
        source.half_axis[1] = cross(source.normal, source.half_axis[0]);
    } else {
        set_square_axes(source);
    }
}

void set_cylinder(const Scene& scene, PrimitiveId id, LightSource& source,
                  std::vector<std::string>& warnings) {
    const auto numbers = scene.reals(id);
    const Vec3 p0 = vec(numbers, 0), p1 = vec(numbers, 3);
    const double size = length(p1 - p0), radius = std::fabs(numbers[6]);
    if (!(size > 0) || radius <= same_place) throw scene.error(id, "light source has no area");
    if (radius > 0.2 * size)
        warnings.push_back(
            scene.error(id, "light source is too thick for a cylinder", "its ends give no light").what());
    const Vec3 axis = (p1 - p0) / size;
    source.extent = LightSource::Extent::cylinder;
    source.center = (p0 + p1) * 0.5;
    source.radius = 0.5 * size;
    source.size = 2 * radius * size;
    Vec3 u, v;
    make_frame(axis, u, v);
    constexpr double within = 0.8559;  // of the radius: samples stay inside the round outline
    source.half_axis[0] = axis * (0.5 * size);
    source.half_axis[1] = u * (within * radius);
    source.half_axis[2] = v * (within * radius);
}

void set_sphere(const Scene& scene, PrimitiveId id, LightSource& source) {
    const auto numbers = scene.reals(id);
    if (numbers[3] <= same_place) throw scene.error(id, "light source has no radius");
    source.extent = LightSource::Extent::sphere;
    source.round = true;
    source.center = vec(numbers, 0);
    source.radius = numbers[3];
    source.size = pi * source.radius * source.radius;
    constexpr double within = 0.7236;  // cube of samples as large as the ball
    for (int i = 0; i < 3; ++i) source.half_axis[i][i] = within * source.radius;
}

void set_ring(const Scene& scene, PrimitiveId id, LightSource& source) {
    const auto numbers = scene.reals(id);
    const double inner = std::min(numbers[6], numbers[7]), outer = std::max(numbers[6], numbers[7]);
    const Vec3 axis = vec(numbers, 3);
    if (inner > 0)
        throw scene.error(id, "light source cannot be a ring with a hole", "its centre gives no light");
    if (outer <= same_place || !(length(axis) > 0)) throw scene.error(id, "light source has no area");
    source.extent = LightSource::Extent::flat;
    source.round = true;
    source.center = vec(numbers, 0);
    source.normal = normalize(axis);
    source.radius = outer;
    source.size = pi * outer * outer;
    set_square_axes(source);
}

void set_distant(const Scene& scene, PrimitiveId id, LightSource& source) {
    const auto numbers = scene.reals(id);
    const Vec3 direction = vec(numbers, 0);
    if (!(length(direction) > 0)) throw scene.error(id, "source direction is zero");
    const double half_angle = numbers[3] * pi / 360.0;
    if (half_angle <= same_place) throw scene.error(id, "source angle must be above 0 degrees");
    source.extent = LightSource::Extent::distant;
    source.round = true;
    source.center = normalize(direction);
    source.normal = source.center;
    source.size = 2 * pi * (1.0 - std::cos(half_angle));
    // The rim of a half space belongs to it, so that sky and sea leave no gap.
    const double rim = source.size > pi ? 1e-6 : 0.0;
    source.least_cosine = 1.0 - (source.size + rim) / (2 * pi);
    source.radius = std::sqrt(source.size / pi);
    set_square_axes(source);
}

// Whether any of a flat spotlight's beam leaves its front.
bool beam_leaves_front(const SpotBeam& beam, const Vec3& normal) {
    const double d = dot(beam.axis, normal);
    if (d > same_place) return true;
    const double edge = 1.0 - beam.solid_angle / (2 * pi);
    return 1.0 - same_place - d * d < edge * edge;
}

}  // namespace

LightSource make_light_source(const Scene& scene, PrimitiveId id, const Emitter& emitter,
                              std::vector<std::string>& warnings) {
    LightSource source;
    switch (scene.type(id)) {
        case PrimitiveType::polygon:
            set_polygon(scene, id, source, warnings);
            break;
        case PrimitiveType::cylinder:
            set_cylinder(scene, id, source, warnings);
            break;
        case PrimitiveType::sphere:
            set_sphere(scene, id, source);
            break;
        case PrimitiveType::ring:
            set_ring(scene, id, source);
            break;
        case PrimitiveType::source:
            set_distant(scene, id, source);
            break;
        default:
            throw scene.error(id, "a " + std::string(name(scene.type(id))) + " cannot be a light source",
                              "use polygon, ring, sphere, cylinder or source; or a glow with maxrad 0");
    }
    const bool distant = source.extent == LightSource::Extent::distant;
    source.passes_unseen = emitter.passes_unseen();
    source.is_weak = emitter.kind() == Emitter::Kind::illum || emitter.kind() == Emitter::Kind::glow;
    if (emitter.kind() == Emitter::Kind::glow) {
        source.is_glow = true;
        source.reach = emitter.reach();
        source.skip = distant;
    } else if (emitter.kind() == Emitter::Kind::spotlight) {
        source.is_spot = true;
        source.beam = emitter.beam();
        if (distant) warnings.push_back(scene.error(id, "distant source is a spotlight").what());
        if (source.extent == LightSource::Extent::flat && !beam_leaves_front(source.beam, source.normal)) {
            warnings.push_back(
                scene.error(id, "spotlight shines backward", "the source gives no light").what());
            source.skip = true;
        }
    }
    return source;
}

}  // namespace infra
