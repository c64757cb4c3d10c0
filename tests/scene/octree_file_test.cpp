#include "scene/octree_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "scene/byte_reader.h"
#include "scene/byte_writer.h"
#include "scene/octree_build.h"
#include "scene_text.h"

namespace infra {
namespace {

using test::reals_of;
using test::scene_of;
using test::strings_of;

constexpr const char* scene_text = R"(
void brightfunc tiles 4 tile tiles.cal -rx 90 0 2 .25 -3
tiles plastic red 0 0 5 .5 .1 .1 0 0
void alias crimson red
crimson sphere ball 0 0 4 0 0 0 1
red polygon floor 0 0 12 -1 -1 -1 1 -1 -1 1 1 -1 -1 1 -1
)";

OctreeFile octree_of(Scene scene, bool frozen) {
    OctreeFile file;
    file.header = {"#?RADIANCE", "oconv test.rad"};
    file.frozen = frozen;
    file.scene = std::move(scene);
    file.cube = bounding_cube(file.scene, 0);
    add_to_octree(file.tree, file.cube, file.scene, 0, {.objects = 1, .resolution = 8}, no_warnings());
    return file;
}

std::string bytes_of(const OctreeFile& file) {
    std::ostringstream out;
    write_octree(out, file);
    return out.str();
}

std::string temporary(const std::string& name, const std::string& content) {
    const std::string path = ::testing::TempDir() + "infra_scene_" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

void expect_same_scene(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.size(), b.size());
    for (PrimitiveId id = 0; id < a.size(); ++id) {
        EXPECT_EQ(a.type(id), b.type(id));
        EXPECT_EQ(a.name(id), b.name(id));
        EXPECT_EQ(a.modifier(id), b.modifier(id));
        EXPECT_EQ(strings_of(a, id), strings_of(b, id));
        ASSERT_EQ(a.reals(id).size(), b.reals(id).size());
        for (std::size_t i = 0; i < a.reals(id).size(); ++i)
            EXPECT_NEAR(a.reals(id)[i], b.reals(id)[i], 1e-9);  // 31 bits in a frozen file
    }
}

TEST(OctreeFile, FrozenRoundTrip) {
    const OctreeFile written = octree_of(scene_of(scene_text), true);
    const std::string path = temporary("frozen.oct", bytes_of(written));
    const OctreeFile read = load_octree(path, no_warnings(), OctreePart::tree);
    EXPECT_TRUE(read.frozen);
    EXPECT_EQ(read.header, written.header);
    EXPECT_NEAR(read.cube.size, written.cube.size, 1e-9);
    expect_same_scene(read.scene, written.scene);
    EXPECT_EQ(bytes_of(read), bytes_of(written));
    EXPECT_EQ(read.scene.location(3).file, path);
    EXPECT_EQ(read_octree_cube(path).size, read.cube.size);
}

TEST(OctreeFile, RoundTripThroughSceneFiles) {
    const std::string scene_path = temporary("scene.rad", scene_text);
    OctreeFile written = octree_of(scene_of(scene_text), false);
    written.scene_files = {scene_path};
    const OctreeFile read = load_octree(temporary("plain.oct", bytes_of(written)), no_warnings());
    EXPECT_FALSE(read.frozen);
    EXPECT_EQ(read.scene_files, written.scene_files);
    expect_same_scene(read.scene, written.scene);
    EXPECT_EQ(read.scene.location(4).line, 6);
    EXPECT_EQ(read.tree.root, empty_node);
}

TEST(OctreeFile, FromACommand) {
    const std::string path = temporary("piped.oct", bytes_of(octree_of(scene_of(scene_text), true)));
    EXPECT_EQ(load_octree("!cat " + path, no_warnings()).scene.size(), 5);
}

TEST(OctreeFile, EmptyScene) {
    const std::string path = temporary("void.oct", bytes_of(octree_of(Scene(), true)));
    const OctreeFile read = load_octree(path, no_warnings());
    EXPECT_EQ(read.scene.size(), 0);
    EXPECT_EQ(read.cube.size, 0);
}

TEST(OctreeFile, OurTypesAreNamedOnlyWhenUsed) {
    EXPECT_EQ(bytes_of(octree_of(scene_of(scene_text), true)).find("emissive"), std::string::npos);
    const OctreeFile hot =
        octree_of(scene_of("void emissive hot 0 0 3 1 1 1\nhot sphere s 0 0 4 0 0 0 1"), true);
    const std::string bytes = bytes_of(hot);
    EXPECT_NE(bytes.find("emissive"), std::string::npos);
    EXPECT_EQ(bytes.find("nrlbrdf"), std::string::npos);
    expect_same_scene(load_octree(temporary("hot.oct", bytes), no_warnings()).scene, hot.scene);
}

TEST(OctreeFile, TooManyArgumentsToFreeze) {
    Scene scene = scene_of("void plastic red 0 0 5 1 1 1 0 0");
    std::vector<double> corners;
    for (int i = 0; i < 12000; ++i)
        corners.insert(corners.end(), {std::cos(i * 5e-4), std::sin(i * 5e-4), 0.0});
    scene.add(PrimitiveType::polygon, 0, "round", {}, corners);
    EXPECT_THROW(bytes_of(octree_of(std::move(scene), true)), Error);
}

TEST(OctreeFile, CutAtEveryByte) {
    const std::string whole = bytes_of(octree_of(scene_of(scene_text), true));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::string path = temporary("cut.oct", whole.substr(0, length));
        EXPECT_THROW(load_octree(path, no_warnings(), OctreePart::tree), Error) << length;
    }
}

TEST(OctreeFile, EveryByteDamaged) {
    const std::string whole = bytes_of(octree_of(scene_of("void sphere s 0 0 4 0 0 0 1"), true));
    int refused = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (const char value : {'\0', '\x7f', '\xff', char(whole[i] ^ 1)}) {
            std::string damaged = whole;
            damaged[i] = value;
            try {
                load_octree(temporary("damaged.oct", damaged), no_warnings(), OctreePart::tree);
            } catch (const Error&) {
                ++refused;
            }
        }
    EXPECT_GT(refused, 100);
}

TEST(ByteFormat, NumbersSurvive) {
    const std::vector<double> reals = {0, 1, -1, .5, 1e-30, -3.14159265358979, 6e37, 1e300, 1e-300};
    const std::vector<std::int64_t> integers = {0, 1, -1, 127, -128, 2147483647, -2147483648LL};
    std::ostringstream out;
    ByteWriter writer(out);
    for (const double value : reals) writer.real(value);
    for (const auto value : integers) writer.integer(value, 4);
    writer.finish();
    std::FILE* const file = std::fopen(temporary("numbers", out.str()).c_str(), "rb");
    ByteReader reader(file, "numbers", "octree");
    for (const double value : reals) {
        if (value == 1e300) {
            EXPECT_NEAR(reader.real(), std::ldexp(1.0, 127), 1e30);  // the largest there is
        } else if (value == 1e-300) {
            EXPECT_EQ(reader.real(), 0);
        } else {
            EXPECT_NEAR(reader.real(), value, std::abs(value) * 1e-9);
        }
    }
    for (const auto value : integers) EXPECT_EQ(reader.integer(4), value);
    EXPECT_THROW(reader.byte(), Error);
    std::fclose(file);
}

}  // namespace
}  // namespace infra
