#include "scene/surface_geometry.h"

#include <algorithm>
#include <cmath>

namespace infra {
namespace {

Vec3 vec(std::span<const double> reals, std::size_t first) {
    return {reals[first], reals[first + 1], reals[first + 2]};
}

int sign(double length) { return (length > tiny_length) - (length < -tiny_length); }

bool is_cylindric(PrimitiveType type) {
    return type == PrimitiveType::cylinder || type == PrimitiveType::tube;
}

SurfaceCheck check_polygon(std::span<const double> reals) {
    const std::size_t corners = reals.size() / 3;
    const Vec3 first = vec(reals, 0);
    Vec3 normal(0);
    for (std::size_t i = 2; i < corners; ++i)
        normal += cross(vec(reals, 3 * i - 3) - first, vec(reals, 3 * i) - first);
    if (normal == Vec3(0)) return {false, "zero area"};
    if (corners == 3) return {};
    // RADIANCE's allowance: 1e-5 of the plane's distance from the origin, or absolute for a plane through it.
    constexpr double allowance = 1e-5;
    normal = normalize(normal);
    double sum = 0;
    for (std::size_t i = 0; i < corners; ++i) sum += dot(normal, vec(reals, 3 * i));
    const double offset = sum / double(corners);
    const double limit = allowance * (std::abs(offset) > allowance ? std::abs(offset) : 1.0);
    for (std::size_t i = 0; i < corners; ++i)
        if (std::abs(dot(normal, vec(reals, 3 * i)) - offset) > limit) return {true, "non-planar vertex"};
    return {};
}

SurfaceCheck check_turned(PrimitiveType type, std::span<const double> reals) {
    const bool ring = type == PrimitiveType::ring;
    const int s0 = sign(reals[6]), s1 = is_cylindric(type) ? s0 : sign(reals[7]);
    if (s0 + s1 == 0) return {false, "illegal radii"};
    if (ring && (s0 < 0 || s1 < 0 || std::abs(reals[7] - reals[6]) <= tiny_length))
        return {false, "illegal radii"};
    const Vec3 axis = ring ? vec(reals, 3) : vec(reals, 3) - vec(reals, 0);
    if (axis == Vec3(0)) return {false, "unknown orientation"};
    if (s0 < 0 || s1 < 0) return {true, is_cylindric(type) ? "negative radius" : "negative radii"};
    return {};
}

void add_circle(Box& box, const Vec3& center, const Vec3& normal, double radius) {
    const Vec3 n2 = normal * normal;
    const Vec3 reach(std::sqrt(std::max(0.0, 1 - n2.x)), std::sqrt(std::max(0.0, 1 - n2.y)),
                     std::sqrt(std::max(0.0, 1 - n2.z)));
    box.add(center - radius * reach);
    box.add(center + radius * reach);
}

}  // namespace

void Box::add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void Box::add(const Box& other) {
    if (other.empty()) return;
    add(other.low);
    add(other.high);
}

/// The nearest point lies in the half-plane of p and the axis, so this is the distance to a segment in that
/// plane.
double TurnedLine::distance(const Vec3& p) const {
    const Vec3 from_base = p - base;
    const double z = dot(from_base, axis);
    const double r = length(from_base - z * axis);
    const double dr = r1 - r0;
    const double along = (z * height + (r - r0) * dr) / (height * height + dr * dr);
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(z - t * height, r - r0 - t * dr);
}

TurnedLine turned_line(const Scene& scene, PrimitiveId id) {
    const auto reals = scene.reals(id);
    TurnedLine line;
    line.base = vec(reals, 0);
    line.r0 = std::abs(reals[6]);
    line.r1 = is_cylindric(scene.type(id)) ? line.r0 : std::abs(reals[7]);
    const Vec3 axis = scene.type(id) == PrimitiveType::ring ? vec(reals, 3) : vec(reals, 3) - line.base;
    line.axis = normalize(axis);
    line.height = scene.type(id) == PrimitiveType::ring ? 0.0 : length(axis);
    return line;
}

SurfaceCheck check_surface(const Scene& scene, PrimitiveId id) {
    check_arguments(scene, id);
    const auto reals = scene.reals(id);
    switch (scene.type(id)) {
        case PrimitiveType::polygon:
            return check_polygon(reals);
        case PrimitiveType::sphere:
        case PrimitiveType::bubble:
            if (sign(reals[3]) == 0) return {false, "zero radius"};
            return {true, reals[3] < 0 ? "negative radius" : ""};
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring:
            return check_turned(scene.type(id), reals);
        default:
            return {};
    }
}

Box surface_box(const Scene& scene, PrimitiveId id, InstanceBoxes& instances) {
    Box box;
    const auto reals = scene.reals(id);
    switch (scene.type(id)) {
        case PrimitiveType::polygon:
            for (std::size_t i = 0; i + 2 < reals.size(); i += 3) box.add(vec(reals, i));
            break;
        case PrimitiveType::sphere:
        case PrimitiveType::bubble:
            box.add(vec(reals, 0) - Vec3(std::abs(reals[3])));
            box.add(vec(reals, 0) + Vec3(std::abs(reals[3])));
            break;
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring: {
            if (!check_surface(scene, id).usable) break;
            const TurnedLine line = turned_line(scene, id);
            add_circle(box, line.base, line.axis, line.r0);
            add_circle(box, line.base + line.height * line.axis, line.axis, line.r1);
            break;
        }
        case PrimitiveType::instance:
        case PrimitiveType::mesh:
            for (const Vec3& corner : instances.at(id).corners()) box.add(corner);
            break;
        default:
            break;
    }
    return box;
}

}  // namespace infra
