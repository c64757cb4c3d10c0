#include "scene/mesh/mesh_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.h"
#include "scene/mesh/direction_code.h"
#include "scene/octree_format.h"

namespace infra {
namespace {

constexpr std::uint32_t free_slot = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_numbered_patches = std::size_t(1) << 21;  // triangles' numbers stay positive

std::uint32_t fraction(double value, double low, double size) {
    constexpr double fractions = 4294967296.0;
    const double scaled = fractions * (value - low) / size;
    return static_cast<std::uint32_t>(std::clamp(scaled, 0.0, fractions - 1));
}

/// Beyond the values themselves, so that the lowest is not 0, which means none.
std::array<Uv, 2> with_margin(std::array<Uv, 2> range) {
    auto& [low, high] = range;
    if (low[0] > high[0]) return {};
    for (int i = 0; i < 2; ++i) {
        const double margin = 2.0 / 65536 * (high[i] - low[i]) +
                              std::max({tiny_length, 1e-12 * std::abs(low[i]), 1e-12 * std::abs(high[i])});
        low[i] -= margin;
        high[i] += margin;
    }
    return range;
}

std::uint32_t patch_of(std::uint32_t vertex) { return vertex >> vertex_bits; }
std::uint8_t local(std::uint32_t vertex) { return static_cast<std::uint8_t>(vertex); }

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
    return hash ^ hash >> 29;
}

template <class Vertex>
std::uint64_t hash_of(const Vertex& v) {
    const auto pair = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t(a) << 32 | b; };
    const std::uint64_t place = mixed(pair(v.position[0], v.position[1]), pair(v.position[2], v.normal));
    return mixed(place, pair(v.uv[0], v.uv[1]));
}

/// Turns the corners until the last two are of one patch, if any two are.
void join_last(std::array<std::uint32_t, 3>& v) {
    if (patch_of(v[0]) == patch_of(v[1]))
        std::rotate(v.begin(), v.begin() + 2, v.end());
    else if (patch_of(v[0]) == patch_of(v[2]))
        std::rotate(v.begin(), v.begin() + 1, v.end());
}

}  // namespace

PatchPacker::PatchPacker(const MeshTriangles& triangles, const Cube& cube)
    : triangles_(triangles), cube_(cube) {
    packed_.uv_range = with_margin(triangles.uv_range);
}

PatchPacker::Vertex PatchPacker::encode(std::size_t triangle, int corner) const {
    Vertex vertex{};
    const VertexLists& lists = triangles_.vertices;
    const Vec3& p = lists.positions[triangles_.positions[triangle][corner]];
    for (int i = 0; i < 3; ++i) vertex.position[i] = fraction(p[i], cube_.origin[i], cube_.size);
    if (!triangles_.normals.empty())
        if (const auto at = triangles_.normals[triangle][corner]; at != Corner::no_index)
            vertex.normal = encode_direction(lists.normals[at]);
    if (!triangles_.uv.empty())
        if (const auto at = triangles_.uv[triangle][corner]; at != Corner::no_index) {
            const auto& [low, high] = packed_.uv_range;
            for (int i = 0; i < 2; ++i) vertex.uv[i] = fraction(lists.uv[at][i], low[i], high[i] - low[i]);
        }
    return vertex;
}

void PatchPacker::grow_table() {
    table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), free_slot);
    for (std::size_t i = 0; i < packed_.positions.size(); ++i) {
        std::size_t slot = hash_of(vertex_at(std::uint32_t(i))) & (table_.size() - 1);
        while (table_[slot] != free_slot) slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = std::uint32_t(i);
    }
}

std::uint32_t PatchPacker::add_vertex(const Vertex& vertex) {
    const std::size_t number = packed_.positions.size();
    if (number % most_patch_vertices == 0) {
        if (packed_.patches.size() == most_numbered_patches)
            throw Error("more vertices than a mesh can number (5e8)");
        packed_.patches.emplace_back();
    }
    packed_.positions.push_back(vertex.position);
    packed_.normals.push_back(vertex.normal);
    packed_.uv.push_back(vertex.uv);
    return std::uint32_t(number);
}

std::uint32_t PatchPacker::find_or_add(const Vertex& vertex) {
    if (2 * packed_.positions.size() >= table_.size()) grow_table();
    std::size_t slot = hash_of(vertex) & (table_.size() - 1);
    for (; table_[slot] != free_slot; slot = (slot + 1) & (table_.size() - 1)) {
        const std::uint32_t i = table_[slot];
        if (packed_.positions[i] == vertex.position && packed_.normals[i] == vertex.normal &&
            packed_.uv[i] == vertex.uv)
            return i;
    }
    return table_[slot] = add_vertex(vertex);
}

std::uint32_t PatchPacker::add(std::size_t triangle) {
    std::array<std::uint32_t, 3> vertices;
    for (int corner = 0; corner < 3; ++corner) vertices[corner] = find_or_add(encode(triangle, corner));
    return place(vertices, triangles_.material(triangle));
}

/// As RADIANCE packs: within a patch if all corners are of one, else in the patch of two of them, else in the
/// one with the fewest such triangles.
std::uint32_t PatchPacker::place(std::array<std::uint32_t, 3> v, std::int16_t material) {
    const auto number = [](std::uint32_t patch, int first, std::size_t count) {
        return patch << triangle_bits | (std::uint32_t(first) + std::uint32_t(count) - 1);
    };
    if (patch_of(v[0]) == patch_of(v[1]) && patch_of(v[1]) == patch_of(v[2])) {
        auto& list = packed_.patches[patch_of(v[0])].local;
        if (list.size() < most_local_triangles) {
            list.push_back({{local(v[0]), local(v[1]), local(v[2])}, material});
            return number(patch_of(v[0]), 0, list.size());
        }
    } else {
        join_last(v);
    }
    if (patch_of(v[1]) == patch_of(v[2])) {
        auto& list = packed_.patches[patch_of(v[1])].joining;
        if (list.size() < most_joining_triangles) {
            list.push_back({v[0], {local(v[1]), local(v[2])}, material});
            return number(patch_of(v[1]), first_joining, list.size());
        }
    }
    const auto room = [&](int i) { return packed_.patches[patch_of(v[i])].double_joining.size(); };
    int home = 0;
    for (const int i : {1, 2})
        if (room(i) < room(home)) home = i;
    if (room(home) >= most_joining_triangles) {
        // No patch of its corners has room: copies of them in a later patch do.
        for (std::uint32_t& vertex : v) vertex = add_vertex(vertex_at(vertex));
        return place(v, material);
    }
    auto& list = packed_.patches[patch_of(v[home])].double_joining;
    list.push_back({{v[(home + 1) % 3], v[(home + 2) % 3]}, local(v[home]), material});
    return number(patch_of(v[home]), first_double_joining, list.size());
}

}  // namespace infra
