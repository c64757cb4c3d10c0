// .rtm files: what is written is read again, and damage is refused.
#include "scene/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../common/test_files.h"
#include "scene/mesh/direction_code.h"
#include "scene/mesh/mesh_writer.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

/// A bumpy sheet of 2 n^2 triangles with normals and texture coordinates, in two materials by halves.
class Sheet {
  public:
    explicit Sheet(int n) {
        read_rad_text(materials,
                      "void plastic front 0 0 5 .5 .5 .5 0 0\nvoid metal back 0 0 5 .5 .5 .5 0 0\n",
                      "materials", no_warnings());
        VertexLists& lists = triangles.vertices;
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                const double x = 10.0 * i / n, y = 10.0 * j / n;
                lists.positions.emplace_back(x, y, std::sin(x) * std::cos(y));
                lists.normals.push_back(
                    normalize(Vec3(-std::cos(x) * std::cos(y), std::sin(x) * std::sin(y), 1)));
                lists.uv.push_back({x / 10, y / 5 - 1});
            }
        }
        TriangleCollector collector(triangles, materials);
        FaceNames names;
        const auto corner = [](int at) { return Corner{at, at, at}; };
        for (int i = 0; i < n; ++i) {
            names.material = 2 * i < n ? "front" : "back";
            names.changes = i;
            for (int j = 0; j < n; ++j) {
                const int a = i * (n + 1) + j, b = a + n + 1;
                const std::array quad = {corner(a), corner(b), corner(b + 1), corner(a + 1)};
                collector.face({lists, quad, names, 1, "sheet", 1});
            }
        }
        collector.finish();
    }

    std::string bytes() const {
        std::ostringstream out;
        write_mesh(out, {"#?RADIANCE", "obj2mesh sheet.obj"}, pack_mesh(triangles, {}, no_warnings()),
                   materials);
        return out.str();
    }

    Scene materials;
    MeshTriangles triangles;
};

Mesh mesh_of(const std::string& bytes) {
    const TemporaryFolder folder;
    write_file(folder / "m.rtm", bytes);
    return load_mesh(folder / "m.rtm", no_warnings());
}

struct Point {
    Vec3 position, normal;
    std::array<double, 2> uv;
    std::string_view material;
    bool operator<(const Point& other) const {
        return std::tie(position.x, position.y) < std::tie(other.position.x, other.position.y);
    }
};

TEST(MeshFile, IsReadAsItWasWritten) {
    const Sheet sheet(40);
    const Mesh mesh = mesh_of(sheet.bytes());
    ASSERT_EQ(mesh.triangles.size(), sheet.triangles.size());
    ASSERT_EQ(mesh.header.size(), 2u);
    EXPECT_EQ(mesh.header[1], "obj2mesh sheet.obj");
    ASSERT_EQ(mesh.materials.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 41u * 41u);  // shared again
    double area = 0, wanted_area = 0;
    for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
        const auto [a, b, c] = sheet.triangles.corners(i);
        wanted_area += 0.5 * length(cross(b - a, c - a));
    }
    for (const Mesh::Triangle& t : mesh.triangles) {
        EXPECT_TRUE(t.smooth && t.mapped);
        const auto at = [&](int k) { return mesh.positions[t.vertex[k]]; };
        area += 0.5 * length(cross(at(1) - at(0), at(2) - at(0)));
        const double middle = (at(0).x + at(1).x + at(2).x) / 3;
        EXPECT_EQ(mesh.scene.name(mesh.materials[t.material]), middle < 5 ? "front" : "back");
        for (const std::uint32_t v : t.vertex) {
            const Vec3 p = mesh.positions[v];
            EXPECT_NEAR(p.z, std::sin(p.x) * std::cos(p.y), 1e-8);
            EXPECT_NEAR(mesh.uv[v][0], p.x / 10, 1e-8);
            EXPECT_NEAR(mesh.uv[v][1], p.y / 5 - 1, 1e-8);
            const Vec3 n = normalize(Vec3(-std::cos(p.x) * std::cos(p.y), std::sin(p.x) * std::sin(p.y), 1));
            EXPECT_NEAR(length(mesh.normals[v] - n), 0, 1.1e-4);
        }
    }
    EXPECT_NEAR(area, wanted_area, 1e-6);
}

TEST(MeshFile, EveryTruncationIsRefused) {
    const std::string bytes = Sheet(4).bytes();
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 40) {
        const std::string message = error_of([&] { mesh_of(bytes.substr(0, size)); });
        EXPECT_NE(message, "no error") << size;
    }
}

TEST(MeshFile, FlippedBytesNeverCrash) {
    const std::string bytes = Sheet(6).bytes();
    for (std::size_t i = 0; i < bytes.size(); i += 7) {
        for (const int flip : {0xff, 0x01, 0x80}) {
            std::string damaged = bytes;
            damaged[i] = static_cast<char>(damaged[i] ^ flip);
            try {
                const Mesh mesh = mesh_of(damaged);
                for (const Mesh::Triangle& t : mesh.triangles) {
                    for (const std::uint32_t v : t.vertex) ASSERT_LT(v, mesh.positions.size());
                    ASSERT_LT(t.material, std::int32_t(mesh.materials.size()));
                }
            } catch (const Error&) {
            }
        }
    }
}

TEST(MeshFile, MissingAndForeignFiles) {
    EXPECT_NE(error_of([] { load_mesh("no_such_mesh.rtm", no_warnings()); }).find("cannot find mesh file"),
              std::string::npos);
    EXPECT_NE(error_of([] { mesh_of("#?RADIANCE\nFORMAT=Radiance_octree\n\n"); }).find("Radiance_octree"),
              std::string::npos);
}

/// A fan of many triangles about one point: more than a cell holds, and more than a patch's joining lists.
TEST(MeshFile, CrowdedVertexKeepsAllTriangles) {
    MeshTriangles triangles;
    const Scene none;
    TriangleCollector collector(triangles, none);
    const FaceNames names;
    constexpr int spokes = 3000;
    triangles.vertices.positions.emplace_back(0, 0, 0);
    for (int i = 0; i < spokes; ++i) {
        const double angle = 2 * 3.14159265358979 * i / spokes;
        triangles.vertices.positions.emplace_back(std::cos(angle), std::sin(angle), 0.1);
    }
    for (int i = 0; i < spokes; ++i) {
        const std::array face = {Corner{0}, Corner{1 + i}, Corner{1 + (i + 1) % spokes}};
        collector.face({triangles.vertices, face, names, i, "fan", 1});
    }
    std::string warned;
    const PackedMesh packed = pack_mesh(triangles, {}, [&](std::string_view text) { warned += text; });
    EXPECT_NE(warned.find("triangles meet in a cell"), std::string::npos);
    std::ostringstream out;
    write_mesh(out, {"#?RADIANCE"}, packed, none);
    EXPECT_EQ(mesh_of(out.str()).triangles.size(), std::size_t(spokes));
}

TEST(MeshFile, TriangleUponTriangle) {
    MeshTriangles triangles;
    const Scene none;
    TriangleCollector collector(triangles, none);
    triangles.vertices.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const std::array face = {Corner{0}, Corner{1}, Corner{2}};
    for (int i = 0; i < 1000; ++i) collector.face({triangles.vertices, face, {}, i, "doubles", 1});
    std::ostringstream out;
    write_mesh(out, {"#?RADIANCE"}, pack_mesh(triangles, {}, no_warnings()), none);
    EXPECT_EQ(mesh_of(out.str()).triangles.size(), 1000u);
}

TEST(DirectionCode, IsWithinSixThousandthsOfADegree) {
    for (int i = 0; i < 2000; ++i) {
        const double z = -1 + (i + 0.5) / 1000, phi = 2.399963 * i, r = std::sqrt(1 - z * z);
        const Vec3 v(r * std::cos(phi), r * std::sin(phi), z);
        const Vec3 back = decode_direction(encode_direction(v));
        EXPECT_NEAR(length(back), 1, 1e-12);
        EXPECT_LT(length(back - v), 1.1e-4);
    }
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        EXPECT_EQ(decode_direction(encode_direction(axis)), axis);
    EXPECT_EQ(decode_direction(no_direction), Vec3(0));
}

}  // namespace
}  // namespace infra
