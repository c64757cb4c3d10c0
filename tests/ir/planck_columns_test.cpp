#include <gtest/gtest.h>

#include "common/error.h"
#include "ir/planck/columns.h"

namespace infra::ir {
namespace {

double twice(double value) {
    if (value < 0) throw Error("negative", "try more");
    return 2 * value;
}

std::string error_of(const std::string& text, int column) {
    try {
        convert_column(text, column, twice, "table");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Columns, ConvertsOneAndLeavesTheRest) {
    EXPECT_EQ(convert_column("1 2 3\n", 2, twice, ""), "1 4 3\n");
    EXPECT_EQ(convert_column("1\n2", 1, twice, ""), "2\n4\n");
    EXPECT_EQ(convert_column("# T\n\n \t\n  a\t.5  b \r\n", 2, twice, ""), "# T\n\n \t\n  a\t1  b \r\n");
    EXPECT_EQ(convert_column("x 0.1666666666666\n", 2, twice, ""), "x 0.333333333\n");
    EXPECT_EQ(convert_column("", 3, twice, ""), "");
}

TEST(Columns, NamesTheLine) {
    EXPECT_EQ(error_of("1 2\n\n1\n", 2), "table:3: there is no column 2");
    EXPECT_EQ(error_of("#\n1 x\n", 2), "table:2: \"x\" is not a number");
    EXPECT_EQ(error_of("1\nnan\n", 1), "table:2: \"nan\" is not a number");
    EXPECT_EQ(error_of("1\n-1\n", 1), "table:2: negative (try more)");
}

}  // namespace
}  // namespace infra::ir
