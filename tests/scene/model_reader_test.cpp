// OBJ, STL and PLY: what is read, and what is refused with its line.
#include "scene/mesh/model_reader.h"

#include <gtest/gtest.h>

#include <bit>
#include <sstream>

#include "../common/test_files.h"
#include "scene/mesh/mesh_triangles.h"
#include "scene/mesh/rad_output.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

struct Read {
    MeshTriangles triangles;
    ModelSummary summary;
    long long without_area = 0;
};

Read read(const std::string& file, const std::string& bytes, const std::string& materials = "") {
    const TemporaryFolder folder;
    write_file(folder / file, bytes);
    Scene scene;
    if (!materials.empty()) read_rad_text(scene, materials, "materials", no_warnings());
    Read result;
    TriangleCollector collector(result.triangles, scene);
    result.summary = read_model(folder / file, {}, result.triangles.vertices, collector);
    collector.finish();
    result.without_area = collector.without_area();
    return result;
}

std::string rad_of(const std::string& file, const std::string& bytes, const RadSettings& settings = {}) {
    const TemporaryFolder folder;
    write_file(folder / file, bytes);
    std::ostringstream out;
    RadOutput output(out, settings);
    VertexLists vertices;
    read_model(folder / file, {.forget_vertices = true, .refuse_zero_normals = false}, vertices, output);
    return out.str();
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, IndicesFromBothEndsAndContinuedLines) {
    const Read model = read("m.obj", corners + "f 1 2 3\nf -4 \\\n -2 -1\r\nf 1/ 2//0 3\n");
    ASSERT_EQ(model.triangles.size(), 3u);
    EXPECT_EQ(model.triangles.positions[0], (MeshTriangles::Indices{0, 1, 2}));
    EXPECT_EQ(model.triangles.positions[1], (MeshTriangles::Indices{0, 2, 3}));
    EXPECT_TRUE(model.triangles.normals.empty());
}

TEST(Obj, ConcaveFaceIsCutIntoEars) {
    const Read model = read("m.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
    double area = 0;
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto [a, b, c] = model.triangles.corners(i);
        const Vec3 normal = cross(b - a, c - a);
        EXPECT_GT(normal.z, 0);
        area += 0.5 * normal.z;
    }
    EXPECT_EQ(model.triangles.size(), 3u);
    EXPECT_DOUBLE_EQ(area, 10);
}

TEST(Obj, NormalsTurnAndSmoothTriangles) {
    const std::string normals = "vn 0 0 -2\nvn 0 .6 -.8\nvn 0 0 1\n";
    const Read model =
        read("m.obj", corners + normals + "f 1//1 2//1 3//1\nf 1//1 2//2 3//1\nf 1//3 2//3 3//3\n");
    ASSERT_EQ(model.triangles.size(), 3u);
    EXPECT_EQ(model.triangles.positions[0], (MeshTriangles::Indices{2, 1, 0}));  // turned, flat
    EXPECT_EQ(model.triangles.normals[0][0], Corner::no_index);
    EXPECT_EQ(model.triangles.normals[1], (MeshTriangles::Indices{0, 1, 0}));  // turned, smooth
    EXPECT_EQ(model.triangles.positions[2], (MeshTriangles::Indices{0, 1, 2}));
}

TEST(Obj, FacesWithoutAreaAreCounted) {
    const Read model = read("m.obj", corners + "f 1 2 2\nf 1 2 3\nf 1 1 1 1\ns 1\n");
    EXPECT_EQ(model.triangles.size(), 1u);
    EXPECT_EQ(model.without_area, 2);
    EXPECT_EQ(model.summary.unrecognized, 1);
    EXPECT_EQ(model.summary.statements, 8);
}

TEST(Obj, MaterialsByUsemtlOrElseByGroup) {
    const std::string materials = "void plastic a 0 0 5 1 1 1 0 0\nvoid plastic b 0 0 5 1 1 1 0 0\n";
    const Read model = read("m.obj", corners + "g b x\nf 1 2 3\nusemtl a\nf 1 2 3\n", materials);
    EXPECT_EQ(model.triangles.materials, (std::vector<std::int16_t>{1, 0}));
    EXPECT_TRUE(read("m.obj", corners + "usemtl zz\nf 1 2 3\n").triangles.materials.empty());
    const auto undefined = [&] { read("m.obj", corners + "usemtl bb\nf 1 2 3\n", materials); };
    EXPECT_NE(error_of(undefined).find("m.obj:6: undefined modifier \"bb\""), std::string::npos);
    const auto mixed = [&] { read("m.obj", corners + "f 1 2 3\nusemtl a\nf 1 2 3\n", materials); };
    EXPECT_NE(error_of(mixed).find("m.obj:5: a face without a material"), std::string::npos);
}

const std::string ply_header =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Malformed, NameFileAndLine) {
    const std::string stl = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    const struct {
        const char* file;
        std::string text;
        const char* message;
    } table[] = {
        {"m.obj", "v 1 2\n", "m.obj:1: a vertex without three coordinates"},
        {"m.obj", "v 1 2 nan\n", "m.obj:1: a vertex without"},
        {"m.obj", corners + "vn 0 0 0\n", "m.obj:5: a normal of length zero"},
        {"m.obj", corners + "f 1 2\n", "m.obj:5: a face with fewer than three"},
        {"m.obj", corners + "f 1 2 5\n", "m.obj:5: a face with vertex 5 where there are 4"},
        {"m.obj", corners + "f 1 2 -5\n", "m.obj:5: a face with vertex -5"},
        {"m.obj", corners + "f 0 1 2\n", "m.obj:5: \"0\" is a corner without a vertex"},
        {"m.obj", corners + "f 1 2 99999999999999999999\n", "is no corner"},
        {"m.obj", corners + "f 1/1 2 3\n", "texture coordinate 1 where there are 0"},
        {"m.obj", corners + "f a b c\n", "m.obj:5: \"a\" is no corner of a face"},
        {"m.stl", stl + "endloop\nendfacet\n", "m.stl:7: a facet with fewer than three"},
        {"m.stl", stl, "m.stl:5: the file ends within a facet"},
        {"m.stl", stl + "vertex 1 x 0\n", "m.stl:6: a vertex without three"},
        {"m.stl", stl + "banana\n", "m.stl:6: \"banana\" where a vertex should be"},
        {"m.stl", "short", "m.stl: this is no STL file"},
        {"m.stl", std::string(80, ' ') + std::string("\x02\0\0\0", 4) + std::string(60, '\0'),
         "the file ends in facet 2 of 2"},
        {"m.ply", "plop\n", "m.ply:1: this is no PLY file"},
        {"m.ply", "ply\nformat ascii 1.0\n", "the file ends within its header"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex -3\n",
         "m.ply:3: element vertex has a senseless number"},
        {"m.ply", "ply\nproperty float x\n", "m.ply:2: a property before any element"},
        {"m.ply", ply_header + "0 0 0\n1 0 0\n", "m.ply:12: the file ends in vertex 2 of 3"},
        {"m.ply", ply_header + "0 0 0\n1 0 0\n1 y 0\n", "m.ply:13: a number is missing in vertex 2"},
        {"m.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n", "m.ply:14: a vertex that does not exist"},
        {"m.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n99999999 0 1 3\n", "a list of senseless length"},
        {"m.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n2 0 1\n", "m.ply:14: fewer than three corners"},
    };
    for (const auto& row : table) {
        const std::string message = error_of([&] { read(row.file, row.text); });
        EXPECT_NE(message.find(row.message), std::string::npos) << message;
    }
}

std::string little_endian(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> 8 * i);
    return bytes;
}

TEST(Stl, TextAndBinaryAreTheSame) {
    const std::string text =
        "solid part\nfacet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 1 1e0 .5\n "
        "endloop\n"
        "endfacet\nendsolid part\n";
    std::string binary = "solid, although binary" + std::string(58, ' ') + std::string("\x01\0\0\0", 4);
    for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, .5f})
        binary += little_endian(v);
    binary += std::string(2, '\0');
    for (const Read& model : {read("m.stl", text), read("m.STL", binary)}) {
        ASSERT_EQ(model.triangles.size(), 1u);
        EXPECT_EQ(model.triangles.corners(0)[2], Vec3(1, 1, .5));
    }
    EXPECT_NE(rad_of("m.stl", text).find("white polygon part.1\n0\n0\n9\n"), std::string::npos);
}

TEST(Ply, TextAndBinaryAreTheSame) {
    const Read text = read("m.ply", ply_header + "0 0 0\n1 0 0\n1 1 .5\n3 0 1 2\n");
    std::string binary = ply_header;
    binary.replace(binary.find("ascii"), 5, "binary_little_endian");
    for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, .5f}) binary += little_endian(v);
    binary += std::string("\x03\0\0\0\0\x01\0\0\0\x02\0\0\0", 13);
    for (const Read& model : {read("m.ply", binary), text}) {
        ASSERT_EQ(model.triangles.size(), 1u);
        EXPECT_EQ(model.triangles.corners(0)[2], Vec3(1, 1, .5));
    }
}

TEST(RadOutput, NamesMaterialsAndRules) {
    const std::string obj = corners + "o box\ng left top\nusemtl oak\nf 1 2 3 4\nusemap grain\nf 1 2 3\n";
    const std::string plain = rad_of("m.obj", obj);
    EXPECT_NE(plain.find("oak polygon box.1\n0\n0\n12\n"), std::string::npos) << plain;
    const TemporaryFolder folder;
    write_file(folder / "rules", "# rules\npine ;\nvoid (Group \"top\") (Face [1:1]) ;\n");
    const MaterialRules rules(folder / "rules");
    const std::string mapped = rad_of("m.obj", obj, {.object = "", .rules = &rules});
    EXPECT_EQ(mapped.find("box.1"), std::string::npos) << mapped;
    EXPECT_NE(mapped.find("pine polygon box.2"), std::string::npos) << mapped;
    write_file(folder / "bad", "pine ;\noak (Colour \"x\") ;\n");
    EXPECT_NE(error_of([&] { MaterialRules(folder / "bad"); }).find("bad:2: \"Colour\" is none of"),
              std::string::npos);
}

TEST(RadOutput, SmoothTriangleGetsItsTexture) {
    const std::string obj = corners + "vn 0 0 1\nvn 0 .6 .8\nf 1//1 2//1 3//2\n";
    const std::string smooth = rad_of("m.obj", obj);
    EXPECT_NE(smooth.find("white texfunc Phong\n4 dx dy dz tmesh.cal\n0\n10\t2\n"), std::string::npos)
        << smooth;
    EXPECT_NE(smooth.find("Phong polygon unnamed.1"), std::string::npos);
    EXPECT_EQ(rad_of("m.obj", obj, {.flat = true}).find("texfunc"), std::string::npos);
}

}  // namespace
}  // namespace infra
