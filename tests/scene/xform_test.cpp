#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "common/format.h"
#include "scene/xform/primitive.h"
#include "scene/xform/repetition.h"
#include "scene/xform/run.h"
#include "scene/xform/settings.h"
#include "scene_text.h"

namespace infra::xform {
namespace {

using test::reals_of;
using test::scene_of;
using test::strings_of;

Settings settings_of(const std::string& options) { return *parse_settings(split_words("xform " + options)); }

ParsedPrimitive moved(const std::string& options, std::string_view text) {
    RadParser parser(TextSource(text, "test.rad"));
    parser.next();
    ParsedPrimitive primitive = parser.primitive();
    apply(settings_of(options), primitive, parser.location());
    return primitive;
}

void expect_reals(const ParsedPrimitive& p, const std::vector<double>& expected) {
    ASSERT_EQ(p.reals.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(p.reals[i], expected[i], 1e-12) << i;
}

TEST(XformPrimitive, Shapes) {
    expect_reals(moved("-s 2 -t 1 0 0", "m sphere s 0 0 4 1 2 3 4"), {3, 4, 6, 8});
    expect_reals(moved("-rz 90", "m cylinder c 0 0 7 1 0 0 2 0 0 .5"), {0, 1, 0, 0, 2, 0, .5});
    expect_reals(moved("-s 3", "m cone c 0 0 8 0 0 0 0 0 1 1 2"), {0, 0, 0, 0, 0, 3, 3, 6});
    expect_reals(moved("-t 0 0 5", "m ring r 0 0 8 0 0 0 0 0 1 0 1"), {0, 0, 5, 0, 0, 1, 0, 1});
    expect_reals(moved("-t 0 0 5 -rx 90", "m source s 0 0 4 0 0 1 .5"), {0, -1, 0, .5});
    expect_reals(moved("-s -2", "m sphere s 0 0 4 1 0 0 1"), {-2, 0, 0, 2});
}

TEST(XformPrimitive, MirrorsAndInversionsTurnPolygons) {
    const char* text = "m polygon p 0 0 9 0 0 0 1 0 0 0 1 0";
    expect_reals(moved("-mx", text), {0, 1, 0, -1, 0, 0, 0, 0, 0});
    expect_reals(moved("-I", text), {0, 1, 0, 1, 0, 0, 0, 0, 0});
    expect_reals(moved("-I -mx", text), {0, 0, 0, -1, 0, 0, 0, 1, 0});
}

TEST(XformPrimitive, InsideOut) {
    EXPECT_EQ(moved("-I", "m sphere s 0 0 4 1 2 3 4").type, PrimitiveType::bubble);
    EXPECT_EQ(moved("-I", "m tube s 0 0 7 1 2 3 4 5 6 7").type, PrimitiveType::cylinder);
    EXPECT_EQ(moved("-I -I", "m cone s 0 0 8 1 2 3 4 5 6 7 8").type, PrimitiveType::cone);
    expect_reals(moved("-I", "m ring r 0 0 8 0 0 0 0 0 1 0 1"), {0, 0, 0, 0, 0, -1, 0, 1});
}

TEST(XformPrimitive, Materials) {
    expect_reals(moved("-s 2", "m glow g 0 0 4 1 1 1 3"), {1, 1, 1, 6});
    expect_reals(moved("-s 2", "m emissive g 0 0 4 1 1 1 3"), {1, 1, 1, 6});
    expect_reals(moved("-s 2", "m emissive g 0 0 3 1 1 1"), {1, 1, 1});
    expect_reals(moved("-s 2 -rx 90", "m spotlight g 0 0 7 1 1 1 30 0 0 1"), {1, 1, 1, 30, 0, -2, 0});
    expect_reals(moved("-s 2", "m dielectric g 0 0 5 .25 .25 .81 1.5 0"), {.5, .5, .9, 1.5, 0});
    expect_reals(moved("-s 2", "m mist g 0 0 6 1 1 1 .5 .5 .5"), {.5, .5, .5, .5, .5, .5});
    EXPECT_EQ(moved("-n a", "m mist g 2 sun mirror>lamp 0 0").strings,
              (std::vector<std::string>{"a.sun", "a.mirror>a.lamp"}));
    expect_reals(moved("-s 2", "m plastic g 0 0 5 .5 .5 .5 0 0"), {.5, .5, .5, 0, 0});
}

TEST(XformPrimitive, FunctionsGetTheTransform) {
    EXPECT_EQ(moved("-rx 90", "m brightfunc f 2 a b.cal 0 0").strings,
              (std::vector<std::string>{"a", "b.cal", "-i", "1", "-rx", "90"}));
    EXPECT_EQ(moved("-i 2 -rx 90", "m brightfunc f 2 a b.cal 0 0").strings,
              (std::vector<std::string>{"a", "b.cal", "-i", "2", "-rx", "90"}));
    EXPECT_EQ(moved("", "m brightfunc f 2 a b.cal 0 0").strings, (std::vector<std::string>{"a", "b.cal"}));
    EXPECT_EQ(moved("-s 2", "m instance i 1 x.oct 0 0").strings.size(), 5u);
}

TEST(XformPrimitive, NamesAndModifiersOfSurfacesOnly) {
    const ParsedPrimitive surface = moved("-n a -n b -m blue", "red sphere s 0 0 4 1 2 3 4");
    EXPECT_EQ(surface.name, "a.b.s");
    EXPECT_EQ(surface.modifier, "blue");
    const ParsedPrimitive material = moved("-n a -m blue", "red plastic s 0 0 5 0 0 0 0 0");
    EXPECT_EQ(material.name, "s");
    EXPECT_EQ(material.modifier, "red");
}

TEST(XformPrimitive, WrongCounts) {
    EXPECT_THROW(moved("-s 2", "m sphere s 0 0 3 1 2 3"), Error);
    EXPECT_THROW(moved("-s 2", "m colortext s 2 a b 0 8 1 2 3 4 5 6 7 8"), Error);
}

std::vector<std::string> calls_of(const std::string& line) {
    std::vector<std::string> calls;
    for_each_call(split_words("xform " + line),
                  {[&](std::vector<std::string> words) { calls.push_back(join_command(words)); },
                   [&](const std::string& remark) { calls.push_back(remark); }});
    return calls;
}

TEST(XformRepetition, Arrays) {
    EXPECT_EQ(calls_of("-a 2 -t 1 0 0 x"),
              (std::vector<std::string>{"xform -n a0 -i 0 -t 1 0 0 x", "xform -n a1 -i 1 -t 1 0 0 x"}));
    const auto grid = calls_of("-n lamp -a 2 -t 1 0 0 -a 3 -t 0 1 0 x");
    ASSERT_EQ(grid.size(), 6u);
    EXPECT_EQ(grid[5], "xform -n lamp.1.2 -i 1 -t 1 0 0 -i 2 -t 0 1 0 x");
    EXPECT_THROW(calls_of("-a"), Error);
    EXPECT_THROW(calls_of("-a 0 -t 1 0 0"), Error);
    EXPECT_THROW(calls_of("-a x"), Error);
}

TEST(XformRepetition, ArgumentFiles) {
    const std::string path = ::testing::TempDir() + "infra_xform_arguments";
    std::ofstream(path) << "# remark\n-t 1 0 0\n!xform -n \"b c\" -rx \\\n 90\n";
    EXPECT_EQ(calls_of("-f " + path + " x"), (std::vector<std::string>{"# remark", "xform -n i0 -t 1 0 0 x",
                                                                       "xform -n \"b c.1\" -rx 90 x"}));
    EXPECT_THROW(calls_of("-f"), Error);
    EXPECT_THROW(calls_of("-f /no/such/file x"), Error);
    const std::string itself = testing::TempDir() + "names_itself.txt";
    std::ofstream(itself) << "-t 1 0 0 -f " << itself << "\n";
    EXPECT_THROW(calls_of("-f " + itself), Error);
}

TEST(XformSettings, WhatIsNoOption) {
    for (const char* line : {"-zz", "-rx", "-rx x", "-t 1 2", "-s 0", "-rx 3 -n a", "-n"})
        EXPECT_THROW(settings_of(line), Error) << line;
}

std::string output_of(const std::vector<std::string>& words) {
    std::FILE* const out = std::tmpfile();
    run(words, out);
    std::rewind(out);
    std::string text;
    for (int c = std::getc(out); c != EOF; c = std::getc(out)) text += static_cast<char>(c);
    std::fclose(out);
    return text;
}

TEST(XformRun, OutputIsASceneAgain) {
    const std::string path = ::testing::TempDir() + "infra_xform_scene.rad";
    std::ofstream(path) << "# hull\nvoid brightfunc \"a b\" 3 f x.cal 'two words' 0 1 -2.5\n"
                           "\"a b\" alias c \"a b\"\n!printf 'void sphere s 0 0 4 0 0 0 1\\n'\n";
    const Scene scene = scene_of(output_of({"xform", "-t", "1", "0", "0", path}));
    ASSERT_EQ(scene.size(), 3);
    EXPECT_EQ(scene.name(0), "a b");
    EXPECT_EQ(strings_of(scene, 0)[2], "two words");
    EXPECT_EQ(strings_of(scene, 0)[5], "-t");
    EXPECT_EQ(reals_of(scene, 0)[0], -2.5);
    EXPECT_EQ(reals_of(scene, 2)[0], 1);

    const std::string kept = output_of({"xform", "-c", "-t", "1", "0", "0", path});
    EXPECT_NE(kept.find("\n!printf 'void sphere s 0 0 4 0 0 0 1\\n' | xform -e -t 1 0 0\n"),
              std::string::npos)
        << kept;
}

TEST(XformRun, ABadSceneGivesNoOutput) {
    const std::string path = ::testing::TempDir() + "infra_xform_bad.rad";
    std::ofstream(path) << "void sphere s 0 0 4 0 0 0 1\nvoid sphere s 0 0 4 0 0 0 x\n";
    std::FILE* const out = std::tmpfile();
    EXPECT_THROW(run({"xform", path}, out), Error);
    EXPECT_EQ(std::ftell(out), 0);
    std::fclose(out);
}

}  // namespace
}  // namespace infra::xform
