// Meshes: their triangles, interpolated normals, texture coordinates and materials.
#include <gtest/gtest.h>

#include <numbers>

#include "common/test_files.h"
#include "scene_files.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::words;

class MeshTest : public testing::Test {
  protected:
    test::TemporaryFolder folder_;

    std::string mesh(const std::string& obj, const std::string& materials = "") {
        test::write_mesh_file(folder_ / "m.rtm", obj, materials);
        return folder_ / "m.rtm";
    }
};

// A sphere of radius 1 in n x 2n patches, with its normals.
std::string sphere_model(int n) {
    std::string text;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const Vec3 p =
                test::direction(std::numbers::pi * (i + 0.01) / (n + 0.02), std::numbers::pi * j / n);
            text += words("v", p.x, p.y, p.z) + "\n" + words("vn", p.x, p.y, p.z) + "\n";
        }
    const auto corner = [&](int i, int j) {
        const std::string number = std::to_string(i * 2 * n + j % (2 * n) + 1);
        return number + "//" + number;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            text += words("f", corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)) + "\n";
            text += words("f", corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)) + "\n";
        }
    return text;
}

TEST_F(MeshTest, ASmoothSphereHasTheSpheresNormals) {
    const std::string path = mesh(sphere_model(24));
    test::TracedScene scene("void plastic m 0 0 5 .5 .5 .5 0 0\n" +
                            words("m mesh ball 6", path, "-mx -s 2 -ry 20 0 0"));
    RandomStream random(3, 4);
    for (int n = 0; n < 500; ++n) {
        const Vec3 from = test::direction(std::acos(1.9 * random.uniform() - 0.95),
                                          2 * std::numbers::pi * random.uniform());
        const Ray ray = scene.tracer().primary(from * 5.0, -from, 0);
        Interaction at(ray);
        scene.tracer().cast(at);
        ASSERT_TRUE(at.hit());
        EXPECT_EQ(scene.compiled().surface_name(at.surface), "ball");
        EXPECT_NEAR(length(at.perturbed_normal() - from), 0, 0.003);
        EXPECT_GT(length(at.normal - at.perturbed_normal()), 0) << "the facet's own";
        EXPECT_LT(std::acos(std::min(1.0, dot(at.normal, from))), 0.12);
    }
}

TEST_F(MeshTest, NoRaySlipsThroughItsSeams) {
    test::TracedScene scene("void plastic m 0 0 5 .5 .5 .5 0 0\n" +
                            words("m mesh ball 1", mesh(sphere_model(16)), "0 0"));
    RandomStream random(5, 6);
    for (int n = 0; n < 4000; ++n) {  // at corners and edges, up to the rounding of the file
        const int i = 1 + static_cast<int>(14 * random.uniform()),
                  j = static_cast<int>(32 * random.uniform());
        const Vec3 corner = test::direction(std::numbers::pi * (i + 0.01) / 16.02, std::numbers::pi * j / 16);
        const Vec3 next = test::direction(std::numbers::pi * (i + 1.01) / 16.02, std::numbers::pi * j / 16);
        const Vec3 target = n % 2 ? corner : corner + (next - corner) * random.uniform();
        EXPECT_GE(scene.nearest({0, 0, 0.01}, normalize(target - Vec3{0, 0, 0.01})).surface, 0);
    }
}

const std::string square =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt .25 0\nvt 1 0\nvt 1 .5\nvt .25 .5\nusemtl front\n"
    "f 1/1 2/2 3/3\nusemtl back\nf 1/1 3/3 4/4\n";
const std::string materials =
    "void brightfunc u 2 Lu+10*Lv . 0 0\nu glow front 0 0 4 1 1 1 0\nvoid plastic back 0 0 5 .5 .5 .5 0 0\n";

TEST_F(MeshTest, MaterialsAndTextureCoordinates) {
    const std::string path = mesh(square, materials);
    test::TracedScene scene(words("void mesh sheet 7", path, "-s 2 -t 0 0 5 0 0"));
    const HitState front = scene.nearest({3, 0.5, 9}, {0, 0, -1}),
                   back = scene.nearest({1, 1.5, 9}, {0, 0, -1});
    EXPECT_EQ(scene.compiled().surface_name(front.surface), "M-Tri");
    EXPECT_EQ(scene.compiled().modifier_name(front.surface), "front");
    EXPECT_EQ(scene.compiled().modifier_name(back.surface), "back");
    EXPECT_NEAR(front.distance, 4, 1e-6);
    // (3, .5, 5) is (1.5, .25) in the mesh: Lu = .25 + .75 * .75, Lv = .5 * .25
    EXPECT_NEAR(static_cast<double>(scene.radiance({3, 0.5, 9}, {0, 0, -1})[0]), 0.8125 + 1.25, 1e-5);
}

TEST_F(MeshTest, AModifierOfItsOwnCoversIts) {
    const std::string path = mesh(square, materials);
    test::TracedScene scene("void brightfunc f 2 Px+10*Lu . 0 0\nf glow own 0 0 4 1 1 1 0\n" +
                            words("own mesh sheet 5", path, "-t 4 0 0 0 0"));
    const HitState hit = scene.nearest({5.5, 0.25, 9}, {0, 0, -1});
    EXPECT_EQ(scene.compiled().surface_name(hit.surface), "sheet");
    EXPECT_EQ(scene.compiled().modifier_name(hit.surface), "own");
    EXPECT_NEAR(static_cast<double>(scene.radiance({5.5, 0.25, 9}, {0, 0, -1})[0]), 5.5 + 8.125, 1e-4);
}

TEST_F(MeshTest, LooksLikeItsPolygons) {
    const std::string path = mesh("v 0 0 0\nv 2 0 0\nv 2 1 1\nv 0 1 1\nf 1 2 3 4\n");
    const std::string paint = "void plastic m 0 0 5 .5 .5 .5 0 0\n";
    const std::string light = "void light l 0 0 3 50 50 50\nl sphere s 0 0 4 1 -1 6 .5\n";
    test::TracedScene placed(paint + words("m mesh sheet 1", path, "0 0\n") + light);
    test::TracedScene written(paint + "m polygon p 0 0 12 0 0 0 2 0 0 2 1 1 0 1 1\n" + light);
    for (int n = 0; n < 20; ++n) {
        const Vec3 from{0.1 + 0.09 * n, 0.1 + 0.04 * n, 5};
        EXPECT_NEAR(static_cast<double>(placed.radiance(from, {0, 0, -1})[0]),
                    static_cast<double>(written.radiance(from, {0, 0, -1})[0]), 1e-4);
    }
}

}  // namespace
}  // namespace infra
