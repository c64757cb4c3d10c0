// How fast rays find the shape they meet, beside Embree where that is installed.
//
//     geometry_benchmark scene.rad... [Google Benchmark's options]
//
// Rays alone, one thread: nothing is shaded. Embree sees the scene's triangles only, so compare on scenes
// that are nothing else (make_hull.py). Per scene: `build` (of the hierarchy), `nearest` and `blocked` by
// kind of ray. With --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true the medians can be
// compared.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "ray_sets.h"
#include "scene/rad_reader.h"
#ifdef INFRADIANCE_EMBREE
#include "embree_scene.h"
#endif

namespace infra::bench {
namespace {

constexpr std::size_t ray_count = 1 << 18;

struct TestScene {
    std::string name;
    Scene text;
    SurfaceTable table;
    std::unique_ptr<Geometry> geometry;
    std::vector<RaySet> sets;
    std::size_t triangles = 0;
    MaterialTraits opaque{.name = "opaque", .blocks_light = true};
#ifdef INFRADIANCE_EMBREE
    std::unique_ptr<EmbreeScene> embree;
#endif

    explicit TestScene(const std::string& path) : name(path.substr(path.rfind('/') + 1)) {
        read_rad(text, path, no_warnings());
        table.finishes.push_back({.material = &opaque});
        for (PrimitiveId id = 0; id < text.size(); ++id)
            if (text.type_info(id).is_geometry()) table.surfaces.push_back({.primitive = id});
        for (const Surface& surface : table.surfaces) triangles += text.reals(surface.primitive).size() == 9;
        geometry = fill();
        geometry->build();
        sets = make_ray_sets(*geometry, ray_count);
#ifdef INFRADIANCE_EMBREE
        std::vector<std::array<Vec3, 3>> corners;
        for (const Surface& surface : table.surfaces)
            if (const auto a = text.reals(surface.primitive); a.size() == 9)
                corners.push_back({Vec3{a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {a[6], a[7], a[8]}});
        embree = std::make_unique<EmbreeScene>(corners);
#endif
    }

    std::unique_ptr<Geometry> fill() const {
        auto shapes = std::make_unique<Geometry>(table);
        shapes->reserve(table.surfaces.size(), triangles);
        int number = 0;
        for (const Surface& surface : table.surfaces) shapes->add(text, surface.primitive, number++);
        return shapes;
    }
};

/// Times ask(ray) over a set's rays, in rays a second.
template <class Ask>
void time_rays(benchmark::State& state, const RaySet& set, Ask&& ask) {
    std::size_t asked = 0;
    for (auto _ : state)
        for (const TestRay& ray : set.rays) {
            benchmark::DoNotOptimize(ask(ray));
            ++asked;
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(asked));
}

template <class Ask>
void add(const std::string& name, const RaySet& set, Ask ask) {
    benchmark::RegisterBenchmark((name + "/" + set.name).c_str(), [&set, ask](benchmark::State& state) {
        time_rays(state, set, ask);
    })->Unit(benchmark::kMillisecond);
}

void add_benchmarks(TestScene& scene) {
    const Geometry& geometry = *scene.geometry;
    benchmark::RegisterBenchmark((scene.name + "/build").c_str(), [&scene](benchmark::State& state) {
        for (auto _ : state) {
            state.PauseTiming();
            auto shapes = scene.fill();
            state.ResumeTiming();
            shapes->build();
            state.PauseTiming();
            shapes.reset();
            state.ResumeTiming();
        }
    })->Unit(benchmark::kMillisecond);
    for (const RaySet& set : scene.sets) {
        add(scene.name + "/nearest", set, [&geometry](const TestRay& ray) {
            HitState state;
            geometry.intersect(ray.origin, ray.direction, ray.leaving, state);
            return state.distance;
        });
        add(scene.name + "/blocked", set, [&geometry](const TestRay& ray) {
            return geometry.view(ray.origin, ray.direction, ray.length, ray.leaving);
        });
#ifdef INFRADIANCE_EMBREE
        constexpr float start = 1e-3f;  // a surface's own hit is nearer
        EmbreeScene& embree = *scene.embree;
        add(scene.name + "/nearest (Embree)", set,
            [&embree](const TestRay& ray) { return embree.intersect(ray, start).distance; });
        add(scene.name + "/blocked (Embree)", set,
            [&embree](const TestRay& ray) { return embree.occluded(ray, start); });
#endif
    }
}

}  // namespace
}  // namespace infra::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::vector<std::unique_ptr<infra::bench::TestScene>> scenes;
    try {
        for (int i = 1; i < argc; ++i) {
            scenes.push_back(std::make_unique<infra::bench::TestScene>(argv[i]));
            add_benchmarks(*scenes.back());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "geometry_benchmark: %s\n", error.what());
        return 1;
    }
    if (scenes.empty()) {
        std::fprintf(stderr, "usage: geometry_benchmark scene.rad... (scenes of triangles)\n");
        return 1;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
