#include "common/error.h"

#include <gtest/gtest.h>

#include <vector>

namespace infra {
namespace {

TEST(Error, LineIsCompleteInItself) {
    EXPECT_STREQ(Error({"hall.rad", 41, 0}, "undefined modifier", "did you mean \"wall\"?").what(),
                 "hall.rad:41: undefined modifier (did you mean \"wall\"?)");
    EXPECT_STREQ(Error({"f.cal", 3, 7}, "syntax error").what(), "f.cal:3:7: syntax error");
    EXPECT_STREQ(Error("cannot open").what(), "cannot open");
}

TEST(EditDistance, CountsInsertionsDeletionsAndSubstitutions) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("abc", ""), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("-abb", "-ab"), 1u);
}

TEST(NearestName, FindsSlipsAndNothingElse) {
    const std::vector<std::string> known{"wall_paint", "floor", "glass"};
    EXPECT_EQ(nearest_name("wal_paint", known), "wall_paint");
    EXPECT_EQ(nearest_name("flor", known), "floor");
    EXPECT_EQ(nearest_name("ceiling", known), "");
}

int body_that_fails(int, char**) { throw Error("no scene", {}, Severity::system); }

TEST(RunProgram, TurnsErrorsIntoExitStatus) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_program("rpict", body_that_fails, 0, nullptr), 2);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "rpict: no scene\n");
}

int body_with_strange_name(int, char**) { throw Error(Location{"a\nb\t.rad", 2, 0}, "odd"); }

TEST(RunProgram, KeepsErrorsToOneLine) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_program("rpict", body_with_strange_name, 0, nullptr), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "rpict: a?b?.rad:2: odd\n");
}

TEST(OneLine, KeepsEverythingElse) { EXPECT_EQ(one_line("M\xc3\xbchle \x7f\x01"), "M\xc3\xbchle ??"); }

}  // namespace
}  // namespace infra
