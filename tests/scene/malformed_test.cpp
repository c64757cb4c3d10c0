// Each file of data/malformed/rad must be refused with its line, what is wrong with it, and no crash.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "scene/octree_build.h"
#include "scene/octree_file.h"
#include "scene/rad_reader.h"

namespace infra {
namespace {

struct Malformed {
    const char* file;
    int line;  ///< 0: none is known
    const char* message;
};

const Malformed table[] = {
    {"alias_of_unknown.rad", 6,
     "undefined target \"pant\" for alias \"second\" (did you mean \"paint\", alias_of_unknown.rad:1?)"},
    {"alias_of_void.rad", 1, "undefined target \"void\""},
    {"alias_without_target.rad", 6, "the file ends before the target"},
    {"command_bad_output.rad", 1, "the file ends before the identifier of a plastic"},
    {"command_loop.rad", 0, "64 levels deep"},
    {"coordinate_beyond_sense.rad", 6, "a coordinate beyond 1e15"},
    {"count_a_fraction.rad", 9, "\"4.5\" where the number of real arguments"},
    {"count_a_word.rad", 7, "\"none\" where the number of string arguments"},
    {"count_beyond_int.rad", 9, "where the number of real arguments"},
    {"count_huge.rad", 9, "more than the limit"},
    {"count_missing.rad", 8, "4 integer arguments"},
    {"count_negative.rad", 9, "a negative number of real arguments, -4"},
    {"count_too_large.rad", 14, "\"paint\" is not a number (real argument 10 of 12 of polygon \"p\")"},
    {"count_too_small.rad", 13, "has polygon \"p\" before it the right number of arguments?"},
    {"cylinder_of_8.rad", 6, "8 real arguments where 7 are needed"},
    {"ends_before_counts.rad", 6, "the file ends before the number of string arguments"},
    {"ends_before_identifier.rad", 6, "the file ends before the identifier of a sphere"},
    {"ends_before_type.rad", 6, "the file ends before the type"},
    {"ends_in_reals.rad", 6, "4 real arguments announced, 2 found"},
    {"ends_in_strings.rad", 1, "3 string arguments announced, 2 found"},
    {"exponent_without_digits.rad", 9, "\"1e\" is not a number"},
    {"hexadecimal.rad", 9, "\"0x10\" is not a number"},
    {"infinity.rad", 9, "\"inf\" is not a number"},
    {"inherit_on_surface.rad", 6, "only an alias can inherit"},
    {"instance_bad_transform.rad", 1, "bad transform"},
    {"instance_missing.rad", 1, "cannot find octree file \"no_such_file.oct\""},
    {"instance_of_nothing.rad", 1, "0 string arguments where at least 1"},
    {"integer_arguments.rad", 8, "1 integer arguments"},
    {"long_word.rad", 1, "a word of more than 511 characters"},
    {"modifier_defined_later.rad", 1, "undefined modifier \"late\""},
    {"modifier_named_inherit.rad", 1, "cannot be the identifier of a modifier"},
    {"modifier_named_void.rad", 1, "cannot be the identifier of a modifier"},
    {"modifier_of_itself.rad", 1, "undefined modifier \"self\""},
    {"nan.rad", 9, "\"nan\" is not a number"},
    {"number_with_unit.rad", 9, "\"1m\" is not a number"},
    {"octree_as_scene.rad", 2, "unknown type \"x\""},
    {"out_of_range.rad", 9, "\"1e999\" is not a number"},
    {"polygon_of_10_numbers.rad", 6, "10 real arguments where 9, 12, 15... are needed"},
    {"polygon_of_2_corners.rad", 6, "6 real arguments where 9, 12, 15... are needed"},
    {"quote_never_closed.rad", 2, "the quote opened by \" is never closed"},
    {"quote_swallows_file.rad", 2, "is its quote closed?"},
    {"ring_of_7.rad", 6, "7 real arguments where 8 are needed"},
    {"second_line_of_command.rad", 4, "\"zero\" is not a number"},
    {"source_of_3.rad", 5, "3 real arguments where 4 are needed"},
    {"sphere_of_3.rad", 6, "(xcent ycent zcent radius)"},
    {"sphere_with_string.rad", 6, "1 string argument where 0 are needed"},
    {"string_count_huge.rad", 2, "more than the limit of 32767"},
    {"surface_as_modifier.rad", 10, "\"ball\" is a sphere, which cannot modify"},
    {"tab_in_identifier.rad", 1, "a tab in the identifier"},
    {"tab_in_modifier.rad", 6, "a tab in the modifier"},
    {"undefined_modifier.rad", 6, "did you mean \"paint\", undefined_modifier.rad:1?"},
    {"undefined_modifier_far.rad", 6, "undefined modifier \"quite_different\" for sphere \"ball\""},
    {"unknown_type.rad", 6, "unknown type \"sphree\" (did you mean sphere?)"},
    {"unknown_type_far.rad", 6, "unknown type \"xyzzyxyzzy\""},
    {"zero_bytes.rad", 1, "a zero byte"},

    {"arguments_negative.oct", 0, "a negative number of arguments"},
    {"cell_of_no_kind.oct", 0, "a cell of no kind"},
    {"cells_without_end.oct", 0, "cells are nested too deep"},
    {"count_negative.oct", 0, "a senseless number of primitives"},
    {"count_wrong.oct", 0, "7 primitives when the octree was made and 2 now; the octree is damaged"},
    {"cube_endless.oct", 0, "this is no octree"},
    {"cube_negative.oct", 0, "its cube has a negative size"},
    {"cube_no_number.oct", 0, "its cube is no number"},
    {"cut_in_scene.oct", 0, "truncated octree"},
    {"empty.oct", 0, "truncated octree"},
    {"header_binary.oct", 0, "this is no octree"},
    {"header_without_end.oct", 0, "truncated octree"},
    {"member_is_material.oct", 0, "a cell holds the plastic \"paint\""},
    {"member_that_is_not.oct", 0, "a cell holds a primitive that does not exist"},
    {"modifier_ahead.oct", 0, "primitive number 1 has no valid modifier"},
    {"modifier_is_surface.oct", 0, "primitive number 2 has no valid modifier"},
    {"no_type.oct", 0, "a primitive of no type"},
    {"picture.oct", 0, "a file of format 32-bit_rle_rgbe"},
    {"scene_file_missing.oct", 0, "cannot open scene file \"no_such_scene.rad\""},
    {"scene_text.oct", 0, "this is no octree"},
    {"set_too_large.oct", 0, "a set of senseless size"},
    {"stale.oct", 0, "octree stale?"},
    {"surface_arguments.oct", 0, "sphere \"ball\": 3 real arguments"},
    {"unknown_type.oct", 0, "primitive of unknown type \"spheroid\""},
    {"wrong_magic.oct", 0, "incompatible octree format"},
};

const std::filesystem::path folder = INFRA_SOURCE_DIR "/tests/data/malformed/rad";

/// What oconv does with the file.
void convert(const std::string& file) {
    if (file.ends_with(".oct")) {
        load_octree(file, no_warnings(), OctreePart::tree);
        return;
    }
    Scene scene;
    read_rad(scene, file, no_warnings());
    Octree tree;
    add_to_octree(tree, bounding_cube(scene, 0), scene, 0, {}, no_warnings());
}

class MalformedScene : public ::testing::TestWithParam<Malformed> {
  protected:
    // Commands in the files name files beside them.
    void SetUp() override { std::filesystem::current_path(folder); }
    void TearDown() override { std::filesystem::current_path(before_); }

  private:
    std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_P(MalformedScene, IsRefused) {
    const Malformed& row = GetParam();
    try {
        convert(row.file);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what();
        EXPECT_EQ(error.where().line, row.line) << error.what();
        EXPECT_EQ(error.severity(), Severity::user);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, MalformedScene, ::testing::ValuesIn(table), [](const auto& test) {
    std::string name = test.param.file;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

TEST(MalformedScenes, EveryFileIsInTheTable) {
    std::set<std::string> in_table, in_folder;
    for (const Malformed& row : table) in_table.insert(row.file);
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        in_folder.insert(entry.path().filename().string());
    EXPECT_EQ(in_table, in_folder);
}

}  // namespace
}  // namespace infra
