// Neighbouring shapes leave no gap: rays to their common edges never slip through.
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

constexpr double pi = std::numbers::pi;
const std::string paint = "void plastic m 0 0 5 .5 .5 .5 0 0\n";

std::string text_of(const Vec3& v) { return words(v.x, v.y, v.z); }

struct Mesh {
    std::string text = paint;
    std::vector<std::array<Vec3, 2>> edges;

    void add(std::initializer_list<Vec3> corners) {
        text += words("m polygon p 0 0", 3 * corners.size());
        for (const Vec3& corner : corners) text += text_of(corner);
        text += "\n";
        const Vec3* list = corners.begin();
        for (std::size_t n = 0; n < corners.size(); ++n)
            edges.push_back({list[n], list[(n + 1) % corners.size()]});
    }
};

/// Rays from origin() to places on random edges; returns how many hit nothing nearer than a bit behind the
/// edge.
template <class Origin>
int leaks(const Mesh& mesh, int count, const Origin& origin) {
    test::TracedScene scene(mesh.text);
    RandomStream random(3, 3);
    int lost = 0;
    for (int n = 0; n < count; ++n) {
        const auto& edge =
            mesh.edges[static_cast<std::size_t>(random.uniform() * static_cast<double>(mesh.edges.size()))];
        const Vec3 target = edge[0] + (edge[1] - edge[0]) * random.uniform();
        const Vec3 from = origin(random);
        lost += scene.nearest(from, normalize(target - from)).surface < 0;
    }
    return lost;
}

Vec3 unit(RandomStream& random) {
    return test::direction(std::acos(2 * random.uniform() - 1), 2 * pi * random.uniform());
}

// A globe of triangles and quadrangles around the poles and between, met from inside.
Mesh globe(int around, int rows, bool split) {
    const auto place = [&](int row, int column) {
        const double turn = 2 * pi * (column % around) / around;
        return test::direction(pi * row / rows, turn + 0.1);
    };
    Mesh mesh;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < around; ++column) {
            const Vec3 a = place(row, column), b = place(row, column + 1), c = place(row + 1, column),
                       d = place(row + 1, column + 1);
            if (row == 0) {
                mesh.add({a, c, d});
            } else if (row == rows - 1) {
                mesh.add({a, c, b});
            } else if (split) {
                mesh.add({a, c, d});
                mesh.add({a, d, b});
            } else {
                mesh.add({a, c, d, b});
            }
        }
    return mesh;
}

TEST(Watertight, GlobeOfTriangles) {
    const Mesh mesh = globe(36, 18, true);
    EXPECT_EQ(leaks(mesh, 400'000, [](RandomStream& random) { return unit(random) * 0.5; }), 0);
}

TEST(Watertight, GlobeOfQuadrangles) {
    const Mesh mesh = globe(36, 18, false);
    EXPECT_EQ(leaks(mesh, 300'000, [](RandomStream& random) { return unit(random) * 0.5; }), 0);
}

TEST(Watertight, CrumpledPlaneOfTriangles) {
    constexpr int size = 20;
    RandomStream random(8, 8);
    std::vector<Vec3> corners;
    for (int i = 0; i <= size; ++i)
        for (int k = 0; k <= size; ++k)
            corners.push_back(
                {i + 0.6 * random.uniform(), k + 0.6 * random.uniform(), 0.2 * random.uniform()});
    const auto at = [&](int i, int k) { return corners[static_cast<std::size_t>(i * (size + 1) + k)]; };
    Mesh mesh;
    for (int i = 0; i < size; ++i)
        for (int k = 0; k < size; ++k) {
            mesh.add({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.add({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    std::erase_if(mesh.edges, [&](const auto& edge) {  // the outline has a neighbour on one side only
        const Vec3 middle = (edge[0] + edge[1]) * 0.5;
        return middle.x < 1.1 || middle.y < 1.1 || middle.x > size - 0.5 || middle.y > size - 0.5;
    });
    EXPECT_EQ(leaks(mesh, 300'000,
                    [](RandomStream& r) {
                        return Vec3{size * r.uniform(), size * r.uniform(), 1 + 30 * r.uniform()};
                    }),
              0);
    EXPECT_EQ(leaks(mesh, 50'000,
                    [](RandomStream& r) {
                        return Vec3{1000 * (r.uniform() - 0.5), 1000 * (r.uniform() - 0.5), 1000};
                    }),
              0);
}

TEST(Watertight, BoxOfPolygonsFromInside) {
    Mesh mesh;
    const auto corner = [](int n) { return Vec3{n & 1 ? 1.7 : -0.3, n & 2 ? 0.9 : -1.1, n & 4 ? 2.3 : 0.1}; };
    constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (const auto& f : faces) mesh.add({corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])});
    EXPECT_EQ(leaks(mesh, 200'000,
                    [](RandomStream& r) {
                        return Vec3{1.6 * r.uniform() - 0.2, 1.8 * r.uniform() - 1, 2 * r.uniform() + 0.2};
                    }),
              0);
}

}  // namespace
}  // namespace infra
