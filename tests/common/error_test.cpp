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

TEST(OneLine, KeepsEverythingElse) {
    EXPECT_EQ(one_line("M\xc3\xbchle \x7f\x01"), "M\xc3\xbchle ??");
    EXPECT_EQ(one_line("\xe6\xb5\xb7 \xf0\x9f\x8c\x8a.rad"), "\xe6\xb5\xb7 \xf0\x9f\x8c\x8a.rad");
}

// Latin 1, a cut character, an overlong '/', a surrogate, a control character of two bytes.
TEST(OneLine, MarksWhatIsNotPrintable) {
    EXPECT_EQ(one_line("M\xfchle"), "M?hle");
    EXPECT_EQ(one_line("a\xe6\xb5"), "a??");
    EXPECT_EQ(one_line("\xc0\xaf"), "??");
    EXPECT_EQ(one_line("\xed\xa0\x80"), "???");
    EXPECT_EQ(one_line("\xc2\x9b"), "??");
}

TEST(MessageLine, CutsLongWords) {
    EXPECT_EQ(message_line(std::string(300, 'x') + " y"), std::string(300, 'x') + " y");
    EXPECT_EQ(message_line("found \"" + std::string(5000000, '1') + "\" (hint)"),
              "found \"" + std::string(299, '1') + "... (hint)");
    std::string umlauts;
    for (int i = 0; i < 301; ++i) umlauts += "\xc3\xbc";
    EXPECT_EQ(message_line(umlauts), umlauts.substr(0, 600) + "...");
}

}  // namespace
}  // namespace infra
