#include "scene/octree.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "scene/octree_build.h"
#include "scene_text.h"

namespace infra {
namespace {

using test::scene_of;

TEST(Octree, EqualSetsShareALeaf) {
    Octree tree;
    const std::vector<PrimitiveId> a = {1, 5, 9}, b = {1, 5};
    const OctreeNode leaf = tree.add_leaf(a);
    EXPECT_TRUE(Octree::is_leaf(leaf));
    EXPECT_NE(tree.add_leaf(b), leaf);
    EXPECT_EQ(tree.add_leaf(a), leaf);
    EXPECT_TRUE(std::ranges::equal(tree.set(leaf), a));
    EXPECT_EQ(tree.add_leaf({}), empty_node);
}

TEST(Octree, ManySets) {
    Octree tree;
    std::vector<OctreeNode> leaves;
    for (PrimitiveId i = 0; i < 20000; ++i) leaves.push_back(tree.add_leaf(std::array{i, i + 1, i + 7}));
    for (PrimitiveId i = 0; i < 20000; ++i)
        EXPECT_TRUE(std::ranges::equal(tree.set(leaves[i]), std::array{i, i + 1, i + 7}));
}

/// A leaf that was forgotten meanwhile has a node of its own, and is the same leaf all the same.
TEST(Octree, EqualSetsMadeFarApartAreUniform) {
    Octree tree;
    std::array<OctreeNode, 8> children;
    children.fill(tree.add_leaf(std::array{3}));
    for (PrimitiveId i = 4; i < 100000; ++i) tree.add_leaf(std::array{i});
    children[7] = tree.add_leaf(std::array{3});
    EXPECT_NE(children[7], children[0]);
    EXPECT_EQ(tree.add_inner(children), children[0]);
}

TEST(Octree, UniformChildrenCollapse) {
    Octree tree;
    std::array<OctreeNode, 8> children;
    children.fill(tree.add_leaf(std::array{3}));
    EXPECT_EQ(tree.add_inner(children), children[0]);
    children[6] = empty_node;
    const OctreeNode inner = tree.add_inner(children);
    EXPECT_TRUE(Octree::is_inner(inner));
    EXPECT_EQ(tree.child(inner, 6), empty_node);
    EXPECT_EQ(tree.child(inner, 7), children[0]);
}

/// The primitives of the leaf that holds a point.
std::set<PrimitiveId> members_at(const Octree& tree, Cube cell, const Vec3& p) {
    OctreeNode node = tree.root;
    while (Octree::is_inner(node)) {
        const Vec3 c = cell.center();
        const int branch = (p.x >= c.x) | (p.y >= c.y) << 1 | (p.z >= c.z) << 2;
        node = tree.child(node, branch);
        cell = cell.octant(branch);
    }
    if (node == empty_node) return {};
    return {tree.set(node).begin(), tree.set(node).end()};
}

TEST(OctreeBuild, CubeIsTheLongestExtentWithAMargin) {
    const Scene scene = scene_of("void sphere a 0 0 4 0 0 0 1\nvoid polygon b 0 0 9 0 0 0 9 0 0 0 2 0\n");
    const Cube cube = bounding_cube(scene, 0);
    EXPECT_NEAR(cube.size, 10 + 2e-5, 1e-12);
    EXPECT_NEAR(cube.origin.x, -1 - 1e-5, 1e-12);
    EXPECT_NEAR(cube.center().y, 0.5, 1e-12);
    EXPECT_NEAR(cube.center().z, 0, 1e-12);
}

TEST(OctreeBuild, NothingToHold) {
    const Scene scene = scene_of("void light sun 0 0 3 1 1 1\nsun source s 0 0 4 0 0 1 .5\n");
    EXPECT_EQ(bounding_cube(scene, 0).size, 0);
    Octree tree;
    add_to_octree(tree, {}, scene, 0, {}, no_warnings());
    EXPECT_EQ(tree.root, empty_node);
}

/// Points on a surface must find it in their cell, however the scene is divided and in how many parts it
/// comes.
TEST(OctreeBuild, EverySurfacePointFindsItsSurface) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    Scene scene = scene_of("void plastic grey 0 0 5 .5 .5 .5 0 0");
    std::vector<std::array<Vec3, 3>> triangles = {{}};  // by primitive
    const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    const auto add = [&](int count) {
        for (int i = 0; i < count; ++i) {
            const Vec3 a = 10.0 * point();
            const std::array<Vec3, 3> t = {a, a + point(), a + point() - 0.5 * point()};
            std::vector<double> reals;
            for (const Vec3& v : t) reals.insert(reals.end(), {v.x, v.y, v.z});
            scene.add(PrimitiveType::polygon, 0, "t", {}, reals);
            triangles.push_back(t);
        }
    };
    add(400);
    const Cube cube{Vec3(-2), 16};
    Octree tree;
    add_to_octree(tree, cube, scene, 0, {.objects = 3, .resolution = 1024}, no_warnings());
    const PrimitiveId second = scene.size();
    add(400);
    add_to_octree(tree, cube, scene, second, {.objects = 3, .resolution = 1024}, no_warnings());
    for (PrimitiveId id = 1; id < scene.size(); ++id)
        for (int k = 0; k < 50; ++k) {
            double u = uniform(random), v = uniform(random);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const auto& t = triangles[id];
            const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
            EXPECT_TRUE(members_at(tree, cube, p).contains(id));
        }
}

TEST(OctreeBuild, CoincidentSurfacesDontDivideForEver) {
    std::string text;
    for (int i = 0; i < 600; ++i) text += "void polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n";
    const Scene scene = scene_of(text);
    std::vector<std::string> warnings;
    Octree tree;
    add_to_octree(tree, bounding_cube(scene, 0), scene, 0, {},
                  [&](std::string_view w) { warnings.emplace_back(w); });
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("left out of a cell that holds 511"), std::string::npos);
}

TEST(OctreeBuild, SurfacesWithoutAreaAreLeftOut) {
    const Scene scene = scene_of(R"(
void sphere big 0 0 4 0 0 0 1
void sphere point 0 0 4 0 0 0 0
void polygon line 0 0 9 0 0 0 .5 0 0 1 0 0
void cylinder disk 0 0 7 0 0 0 0 0 0 1
void ring thin 0 0 8 0 0 0 0 0 1 .5 .5
void sphere inverted 0 0 4 0 0 0 -1
)");
    std::vector<std::string> warnings;
    Octree tree;
    const Cube cube = bounding_cube(scene, 0);
    add_to_octree(tree, cube, scene, 0, {}, [&](std::string_view w) { warnings.emplace_back(w); });
    EXPECT_EQ(warnings, (std::vector<std::string>{"test.rad:3: sphere \"point\": zero radius",
                                                  "test.rad:4: polygon \"line\": zero area",
                                                  "test.rad:5: cylinder \"disk\": unknown orientation",
                                                  "test.rad:6: ring \"thin\": illegal radii",
                                                  "test.rad:7: sphere \"inverted\": negative radius"}));
    EXPECT_EQ(members_at(tree, cube, {0, 0, .99999}), (std::set<PrimitiveId>{0, 5}));
}

TEST(OctreeBuild, SurfacesMustFitTheCube) {
    const Scene scene = scene_of("void sphere ball 0 0 4 0 0 0 1");
    Octree tree;
    try {
        add_to_octree(tree, {Vec3(0), 5}, scene, 0, {}, no_warnings());
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "test.rad:1: sphere \"ball\": sticks out of the octree's cube");
    }
}

}  // namespace
}  // namespace infra
