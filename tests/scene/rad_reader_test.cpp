#include "scene/rad_reader.h"

#include <gtest/gtest.h>

#include "scene_text.h"

namespace infra {
namespace {

using test::reals_of;
using test::scene_of;
using test::strings_of;

constexpr const char* two_reds = R"(
void plastic red 0 0 5 .5 0 0 0 0
red sphere first 0 0 4 0 0 0 1
void plastic red 0 0 5 .9 0 0 0 0
red sphere second 0 0 4 0 0 0 1
)";

TEST(RadReader, AModifierIsTheLatestOfItsName) {
    const Scene scene = scene_of(two_reds);
    ASSERT_EQ(scene.size(), 4);
    EXPECT_EQ(scene.modifier(0), void_primitive);
    EXPECT_EQ(scene.modifier(1), 0);
    EXPECT_EQ(scene.modifier(3), 2);
    EXPECT_EQ(scene.find_modifier("red"), 2);
    EXPECT_EQ(scene.find_modifier_before("red", 2), 0);
    EXPECT_EQ(scene.find_modifier_before("red", 0), void_primitive);
    EXPECT_EQ(scene.find_modifier("first"), void_primitive);
}

TEST(RadReader, ARepeatedDefinitionIsTheFirst) {
    const Scene scene = scene_of(
        "void plastic red 0 0 5 .5 0 0 0 0\nvoid plastic red 0 0 5 .5 0 0 0 0\nred sphere s 0 0 4 0 0 0 1");
    EXPECT_EQ(scene.modifier(2), 0);
}

TEST(RadReader, SameTextCanMeanDifferentThings) {
    // The second mixture names a redefined paint, so it is another one although it reads the same.
    const Scene scene = scene_of(R"(
void plastic paint 0 0 5 .5 0 0 0 0
void mixfunc mix 4 paint void half . 0 0
void plastic paint 0 0 5 .9 0 0 0 0
void mixfunc mix 4 paint void half . 0 0
mix sphere s 0 0 4 0 0 0 1
)");
    EXPECT_EQ(scene.modifier(4), 3);
}

TEST(RadReader, Places) {
    const Scene scene = scene_of(two_reds);
    EXPECT_EQ(scene.location(3).file, "test.rad");
    EXPECT_EQ(scene.location(3).line, 5);
    EXPECT_STREQ(scene.error(3, "is odd", "look").what(), "test.rad:5: sphere \"second\": is odd (look)");
}

TEST(RadReader, AliasAsASecondNamePassesThrough) {
    const Scene scene = scene_of(R"(
void plastic red 0 0 5 .5 0 0 0 0
void alias crimson red
inherit alias scarlet crimson
scarlet sphere s 0 0 4 0 0 0 1
)");
    EXPECT_TRUE(scene.strings(1).empty());
    EXPECT_EQ(scene.modifier(1), 0);
    EXPECT_EQ(scene.modifier(2), 0);  // not 1: chains are cut short
    const ResolvedModifier resolved = scene.resolve(scene.modifier(3));
    EXPECT_EQ(resolved.definition, 0);
    EXPECT_EQ(resolved.modifier, void_primitive);
}

TEST(RadReader, AliasWithAModifierOfItsOwn) {
    const Scene scene = scene_of(R"(
void brightfunc dirt 2 d dirt.cal 0 0
void plastic red 0 0 5 .5 0 0 0 0
dirt alias dirty_red red
dirty_red sphere s 0 0 4 0 0 0 1
void plastic red 0 0 5 .9 0 0 0 0
void alias plain dirty_red
)");
    EXPECT_EQ(strings_of(scene, 2), std::vector<std::string>{"red"});
    const ResolvedModifier resolved = scene.resolve(2);
    EXPECT_EQ(resolved.definition, 1);  // the red before the alias
    EXPECT_EQ(resolved.modifier, 0);
    // An alias of that alias with another modifier: the arguments of red, modified by nothing.
    EXPECT_EQ(scene.resolve(5).definition, 1);
    EXPECT_EQ(scene.resolve(5).modifier, void_primitive);
}

TEST(RadReader, ResolveOfNothing) {
    const Scene scene = scene_of("");
    EXPECT_EQ(scene.resolve(void_primitive).definition, void_primitive);
}

TEST(RadReader, CommandsAreReadInPlace) {
    const Scene scene = scene_of(
        "void plastic red 0 0 5 .5 0 0 0 0\n!echo red sphere a 0 0 \\\n 4 0 0 0 1\nred sphere b 0 0 4 0 0 0 "
        "2\n");
    ASSERT_EQ(scene.size(), 3);
    EXPECT_EQ(scene.name(1), "a");
    EXPECT_EQ(scene.location(1).file, "\"!echo red sphere a 0 0   4 0 0 0 1\"");
    EXPECT_EQ(reals_of(scene, 2)[3], 2);
    EXPECT_EQ(scene.location(2).line, 4);
}

TEST(RadReader, Warnings) {
    std::vector<std::string> warnings;
    scene_of("# nothing\n", &warnings);
    EXPECT_EQ(warnings, std::vector<std::string>{"test.rad: empty file"});
    warnings.clear();
    scene_of("!echo void light l 0 0 3 1 1 1; exit 3\n", &warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].substr(0, 15), "bad status from");
}

TEST(RadReader, MissingFile) {
    Scene scene;
    EXPECT_THROW(read_rad(scene, "no_such_file.rad", no_warnings()), Error);
}

TEST(Scene, StaysValidWhenMovedAndGrown) {
    Scene scene = scene_of(two_reds);
    const std::string_view name = scene.name(1);
    const std::span<const double> reals = scene.reals(1);
    Scene moved = std::move(scene);
    const std::vector<double> many(100000, 1.5);
    for (int i = 0; i < 100; ++i) moved.add(PrimitiveType::polygon, 0, "p" + std::to_string(i), {}, many);
    EXPECT_EQ(name, "first");
    EXPECT_EQ(reals[3], 1);
    EXPECT_EQ(moved.reals(50).size(), many.size());
    EXPECT_EQ(moved.name(103), "p99");
}

}  // namespace
}  // namespace infra
