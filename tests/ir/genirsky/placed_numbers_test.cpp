#include "ir/genirsky/placed_numbers.h"

#include "fixtures.h"

namespace infra::ir {
namespace {

using test::error_of;

TEST(PlacedNumbers, KnowTheirPlaces) {
    const NumberText text = parse_numbers("# head\n1 2.5,\t-3e2\r\n\n  4 # tail\n", "f");
    ASSERT_EQ(text.lines.size(), 2u);
    EXPECT_EQ(text.lines[0][1].value, 2.5);
    EXPECT_EQ(text.lines[0][2].line, 2);
    EXPECT_EQ(text.lines[0][2].column, 8);
    EXPECT_EQ(text.all().size(), 4u);
    EXPECT_EQ(text.all()[3].value, 4);
    EXPECT_EQ(text.last_line, 4);
}

TEST(PlacedNumbers, RefuseWhatIsNone) {
    EXPECT_EQ(error_of([] { parse_numbers("1 2\n3  nan\n", "f"); }),
              "f:2:4: expected a finite number, found \"nan\"");
    EXPECT_EQ(error_of([] { parse_numbers("1 1e999", "f"); }),
              "f:1:3: expected a finite number, found \"1e999\"");
    EXPECT_EQ(error_of([] { parse_numbers("", "f"); }), "f:1: the file has no numbers");
    EXPECT_EQ(error_of([] { parse_numbers("# a\n\n", "f"); }), "f:2: the file has no numbers");
}

}  // namespace
}  // namespace infra::ir
