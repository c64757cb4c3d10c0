#include "scene/rad_parser.h"

#include <gtest/gtest.h>

namespace infra {
namespace {

using Item = RadParser::Item;

RadParser parser_of(std::string_view text) { return RadParser(TextSource(text, "test.rad")); }

TEST(RadParser, AnyLayout) {
    RadParser parser =
        parser_of("void plastic\n\n red 0 0\t5 .5\r\n 5. -1e-1 +.25E2 0\nred sphere s 0 0 4 1 2 3 4");
    ASSERT_EQ(parser.next(), Item::primitive);
    EXPECT_EQ(parser.primitive().modifier, "void");
    EXPECT_EQ(parser.primitive().type, PrimitiveType::plastic);
    EXPECT_EQ(parser.primitive().name, "red");
    EXPECT_EQ(parser.primitive().reals, (std::vector<double>{.5, 5, -.1, 25, 0}));
    ASSERT_EQ(parser.next(), Item::primitive);
    EXPECT_EQ(parser.location().line, 5);
    EXPECT_EQ(parser.primitive().reals, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(parser.next(), Item::end);
}

TEST(RadParser, QuotesKeepBlanks) {
    RadParser parser = parser_of("void brightfunc f 5 \"a b\" 'c \"d\"' e'f g'h \"\" i 0 0");
    ASSERT_EQ(parser.next(), Item::primitive);
    EXPECT_EQ(parser.primitive().strings, (std::vector<std::string>{"a b", "c \"d\"", "ef gh", "", "i"}));
}

TEST(RadParser, CommentsAndCommands) {
    RadParser parser = parser_of("# first\n  # indented\n!xform -rx 90 \\\n  part.rad\n!echo\r\n#last");
    EXPECT_EQ(parser.next(), Item::comment);
    EXPECT_EQ(parser.text(), "# first");
    EXPECT_EQ(parser.next(), Item::comment);
    EXPECT_EQ(parser.next(), Item::command);
    EXPECT_EQ(parser.text(), "!xform -rx 90 \\\n  part.rad");
    EXPECT_EQ(parser.location().line, 3);
    EXPECT_EQ(parser.next(), Item::command);
    EXPECT_EQ(parser.text(), "!echo");
    EXPECT_EQ(parser.location().line, 5);
    EXPECT_EQ(parser.next(), Item::comment);
    EXPECT_EQ(parser.text(), "#last");
    EXPECT_EQ(parser.next(), Item::end);
}

TEST(RadParser, AHashInsideAPrimitiveIsAWord) {
    RadParser parser = parser_of("void brightfunc f 2 # x.cal 0 0");
    ASSERT_EQ(parser.next(), Item::primitive);
    EXPECT_EQ(parser.primitive().strings[0], "#");
}

TEST(RadParser, NamesTheWordThatIsWrong) {
    RadParser parser = parser_of("void plastic red\n0\n0\n5 .5 .5\n.5 zero 0\n");
    try {
        parser.next();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.where().line, 5);
        EXPECT_STREQ(error.what(),
                     "test.rad:5: \"zero\" is not a number (real argument 4 of 5 of plastic \"red\")");
    }
}

TEST(RadParser, LongTextCrossesBuffers) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += "void sphere s" + std::to_string(i) + "\n0\n0\n4 0 0 0 1\n";
    std::FILE* const file = std::tmpfile();
    std::fwrite(text.data(), 1, text.size(), file);
    std::rewind(file);
    RadParser parser(TextSource(file, "long.rad"));
    int count = 0;
    for (; parser.next() == Item::primitive; ++count)
        ASSERT_EQ(parser.primitive().name, "s" + std::to_string(count));
    EXPECT_EQ(count, 20000);
    EXPECT_EQ(parser.location().line, 4 * 19999 + 1);
    std::fclose(file);
}

}  // namespace
}  // namespace infra
