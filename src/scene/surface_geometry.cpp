#include "scene/surface_geometry.h"

#include <algorithm>
#include <array>
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

/// Unit vector by RADIANCE's arithmetic, whose last bits decide which cells a surface touches. Zero stays
/// zero.
Vec3 unit(const Vec3& v) {
    const double squared = dot(v, v);
    if (squared == 0) return Vec3(0);
    const bool nearly_unit = squared <= 1 + tiny_length && squared >= 1 - tiny_length;
    return v * (nearly_unit ? 2 - (0.5 + 0.5 * squared) : 1 / std::sqrt(squared));
}

/// Sum of the cross products of successive diagonals: twice the area long.
Vec3 area_normal(std::span<const Vec3> corners) {
    Vec3 normal(0), previous = corners[1] - corners[0];
    for (const Vec3& corner : corners.subspan(2)) {
        const Vec3 diagonal = corner - corners[0];
        normal += cross(previous, diagonal);
        previous = diagonal;
    }
    return normal;
}

SurfaceCheck check_polygon(std::span<const double> reals) {
    if (reals.size() == 9) {
        const std::array corners{vec(reals, 0), vec(reals, 3), vec(reals, 6)};
        const Vec3 normal = area_normal(corners);
        if (dot(normal, normal) == 0) return {false, "zero area"};
        return {};
    }
    std::vector<Vec3> corners;
    polygon_corners(reals, corners);
    const Vec3 normal = unit(area_normal(corners));
    if (normal == Vec3(0)) return {false, "zero area"};
    if (corners.size() == 3) return {};
    // RADIANCE's allowance: 1e-5 of the plane's distance from the origin, or absolute for a plane through it.
    constexpr double allowance = 1e-5;
    const double offset = corner_plane(corners).offset;
    const double limit = allowance * (std::abs(offset) > allowance ? std::abs(offset) : 1.0);
    for (const Vec3& corner : corners)
        if (std::abs(dot(normal, corner) - offset) > limit) return {true, "non-planar vertex"};
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
    box.add(center + reach * radius);
    box.add(center - reach * radius);
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

void polygon_corners(std::span<const double> reals, std::vector<Vec3>& corners) {
    corners.clear();
    for (std::size_t i = 0; i + 2 < reals.size(); i += 3) corners.push_back(vec(reals, i));
    if (corners.size() <= 3) return;
    const Vec3 closing = corners.back() - corners.front();
    if (dot(closing, closing) <= tiny_length * tiny_length) corners.pop_back();
}

CornerPlane corner_plane(std::span<const Vec3> corners) {
    CornerPlane plane{unit(area_normal(corners))};
    for (const Vec3& corner : corners) plane.offset += dot(plane.normal, corner);
    plane.offset /= double(corners.size());
    return plane;
}

bool TurnedLine::line_towards(const Vec3& point, Vec3& end0, Vec3& end1) const {
    const Vec3 from_base = point - p0;
    const Vec3 outward = unit(from_base - dot(from_base, axis) * axis);
    if (outward == Vec3(0)) return false;
    end0 = r0 * outward + p0;
    end1 = r1 * outward + p1;
    return true;
}

void get_stored_surface(const Scene& scene, PrimitiveId id, StoredSurface& stored) {
    using enum PrimitiveType;
    stored.type = scene.type(id);
    stored.reals = scene.reals(id);
    if (stored.reals.size() > 8 || stored.type == polygon || stored.type == source ||
        !scene.type_info(id).is_geometry())
        return;
    const auto count = stored.reals.size();
    std::ranges::copy(stored.reals, stored.changed);
    stored.reals = {stored.changed, count};
    const auto turn_over = [&](PrimitiveType one, PrimitiveType other) {
        stored.type = stored.type == one ? other : one;
    };
    double* const r = stored.changed;
    if (stored.type == sphere || stored.type == bubble) {
        if (sign(r[3]) >= 0) return;
        turn_over(sphere, bubble);
        r[3] = -r[3];
    } else if (is_cylindric(stored.type)) {
        if (sign(r[6]) >= 0) return;
        turn_over(cylinder, tube);
        r[6] = -r[6];
    } else if (count == 8) {
        const int s0 = sign(r[6]), s1 = sign(r[7]);
        const bool negative = s0 < 0 || s1 < 0;
        if (s0 + s1 == 0 || (negative && stored.type == ring)) return;
        if (negative) turn_over(cone, cup);
        r[6] *= s0;
        r[7] *= s1;
        if (stored.type == ring || sign(r[7] - r[6]) != 0) return;
        stored.type = stored.type == cone ? cylinder : tube;
        stored.reals = {stored.changed, 7};
    }
}

TurnedLine turned_line(const Scene& scene, PrimitiveId id) {
    StoredSurface stored;
    get_stored_surface(scene, id, stored);
    const auto reals = stored.reals;
    const bool is_ring = stored.type == PrimitiveType::ring;
    TurnedLine line;
    line.p0 = vec(reals, 0);
    line.p1 = is_ring ? line.p0 : vec(reals, 3);
    line.r0 = reals[6];
    line.r1 = reals[is_cylindric(stored.type) ? 6 : 7];
    if (line.r0 > line.r1) {
        std::swap(line.p0, line.p1);
        std::swap(line.r0, line.r1);
    }
    line.axis = unit(is_ring ? vec(reals, 3) : line.p1 - line.p0);
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
            box.add(vec(reals, 0) - Vec3(reals[3]));
            box.add((vec(reals, 0) - Vec3(reals[3])) + Vec3(2.0 * reals[3]));
            break;
        case PrimitiveType::cone:
        case PrimitiveType::cup:
        case PrimitiveType::cylinder:
        case PrimitiveType::tube:
        case PrimitiveType::ring: {
            if (!check_surface(scene, id).usable) break;
            const TurnedLine line = turned_line(scene, id);
            if (line.p0 != line.p1) add_circle(box, line.p0, line.axis, line.r0);
            add_circle(box, line.p1, line.axis, line.r1);
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
