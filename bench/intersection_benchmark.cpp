// The parts of a ray's way to its hit: the exact test of a triangle, one step of the walk through the
// hierarchy, and the test of a leaf's triangles in single precision. Nodes are made by hand so that each step
// is the same; all of them are in the cache. What a scene's rays cost in all is geometry_benchmark's.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/random.h"
#include "rt/geometry/bvh_walk.h"
#include "rt/shapes/polygon.h"

namespace {

using namespace infra;

constexpr std::size_t count = 1024;

/// Triangles of all orientations within the unit cube, and rays through it, of which a part meets them.
void triangle(benchmark::State& state) {
    RandomStream stream(1, 0);
    const auto point = [&] { return Vec3{stream.uniform(), stream.uniform(), stream.uniform()}; };
    SurfaceTable table;
    table.finishes.emplace_back();
    table.surfaces.emplace_back();
    std::vector<Triangle> triangles;
    std::vector<std::array<Vec3, 2>> rays;
    for (std::size_t i = 0; i < count; ++i) {
        triangles.emplace_back(point(), point(), point(), 0);
        const Vec3 from = point() + Vec3{0, 0, -2};
        rays.push_back({from, normalize(point() - from)});
    }
    std::size_t i = 0;
    std::int64_t hits = 0;
    for (auto _ : state) {
        HitState hit;
        triangles[i].intersect(rays[i][0], rays[i][1], table, 0, hit);
        hits += hit.surface >= 0;
        i = (i + 1) % count;
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}
BENCHMARK(triangle);

/// A ray along x at y = z = 0.5, that meets boxes of y and z in 0..1 and no others.
BvhRay ray_along_x(const std::vector<BvhNode>& nodes) {
    BvhRay ray{};
    ray.nodes = nodes.data();
    ray.origin = BvhRay::Four{-1, 0.5f, 0.5f, 0};
    ray.inverse = BvhRay::Four{1, 1e12f, 1e12f, 0};
    ray.axis[0] = 1;
    ray.axis[1] = 2;
    ray.axis[2] = ray.axis[3] = 0;
    ray.inverse_along = 1;
    ray.limit = 1000;
    return ray;
}

/// Eight children of which the ray meets the first `met`, one behind the other.
BvhNode node_of(int met, std::uint32_t first_child, std::uint32_t child_step) {
    BvhNode node{};
    for (int axis = 0; axis < 3; ++axis) node.exponent[axis] = 127 - 4;  // steps of 1/16
    node.count = BvhNode::width;
    for (int lane = 0; lane < BvhNode::width; ++lane) {
        const auto aside = static_cast<std::uint8_t>(lane < met ? 0 : 32);
        node.plane[0][0][lane] = static_cast<std::uint8_t>(16 * lane);
        node.plane[1][0][lane] = static_cast<std::uint8_t>(16 * lane + 16);
        for (int axis = 1; axis < 3; ++axis) {
            node.plane[0][axis][lane] = aside;
            node.plane[1][axis][lane] = static_cast<std::uint8_t>(aside + 16);
        }
        node.child[lane] = first_child + child_step * static_cast<std::uint32_t>(lane);
    }
    return node;
}

void walk(benchmark::State& state, BvhKernel kernel, const std::vector<BvhNode>& nodes) {
    for (auto _ : state) {
        BvhRay ray = ray_along_x(nodes);
        kernel(ray);
        benchmark::DoNotOptimize(ray);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(nodes.size()));
}

/// 64 nodes, each with one child that the ray meets; the last has none. An item is a node.
void chain(benchmark::State& state, BvhKernel kernel) {
    std::vector<BvhNode> nodes;
    for (std::uint32_t i = 0; i < 63; ++i) nodes.push_back(node_of(1, i + 1, 0));
    nodes.push_back(node_of(0, 0, 0));
    walk(state, kernel, nodes);
}
BENCHMARK_CAPTURE(chain, best, best_bvh_kernel());
BENCHMARK_CAPTURE(chain, portable, portable_bvh_kernel());

/// A node with as many children that the ray meets, nodes that have none; an item is a node.
void fork(benchmark::State& state, BvhKernel kernel) {
    const auto children = static_cast<int>(state.range(0));
    std::vector<BvhNode> nodes{node_of(children, 1, 1)};
    for (int i = 0; i < children; ++i) nodes.push_back(node_of(0, 0, 0));
    walk(state, kernel, nodes);
}
BENCHMARK_CAPTURE(fork, best, best_bvh_kernel())->Arg(2)->Arg(4)->Arg(8)->ArgName("met");

/// A node and its leaf of eight triangles, all of which the ray misses; an item is a triangle.
void leaf(benchmark::State& state, BvhKernel kernel) {
    // Corners in sixteenths of 256 steps each: triangles beside the ray.
    std::array<Bvh::Item, BvhLeaf::largest> memory{};
    auto& record = *reinterpret_cast<BvhLeaf*>(memory.data());
    record.exponent = 127 - 12;
    constexpr std::uint16_t corners[3][3] = {{4, 6, 5}, {9, 15, 12}, {9, 9, 15}};  // [axis][corner]
    for (unsigned axis = 0; axis < 3; ++axis)
        for (unsigned corner = 0; corner < 3; ++corner)
            for (unsigned i = 0; i < BvhLeaf::largest; ++i)
                record.rows[(3 * axis + corner) * BvhLeaf::largest + i] =
                    static_cast<std::uint16_t>(256 * (corners[axis][corner] + (axis == 0 ? i : 0)));
    std::vector<BvhNode> nodes{node_of(1, BvhLeaf::reference(0, BvhLeaf::largest), 0)};
    bool asked = false;
    for (auto _ : state) {
        BvhRay ray = ray_along_x(nodes);
        ray.leaves = reinterpret_cast<const std::uint8_t*>(memory.data());
        ray.triangle_count = BvhLeaf::largest;
        ray.error = 1.2e-6f;
        ray.visit = [](BvhRay& met, std::uint32_t, unsigned) {
            met.limit = -1;
            return true;
        };
        kernel(ray);
        asked = asked || ray.limit < 0;
    }
    if (asked) state.SkipWithError("the ray should have missed the triangles");
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(BvhLeaf::largest));
}
BENCHMARK_CAPTURE(leaf, best, best_bvh_kernel());
BENCHMARK_CAPTURE(leaf, portable, portable_bvh_kernel());

}  // namespace

BENCHMARK_MAIN();
