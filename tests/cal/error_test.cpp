// What users are told, and where.
#include <gtest/gtest.h>

#include "evaluate.h"

namespace infra::cal {
namespace {

TEST(Errors, SyntaxIsLocatedByLineAndColumn) {
    EXPECT_EQ(error_of("1", "a = 1;\n  f(x) = x + ;\n"),
              "test.cal:2:14: syntax error: a number, a name or '(' expected, but ';' found");
    EXPECT_EQ(error_of("(1"), "test.cal:1:3: syntax error: ')' expected, but the text ends");
    EXPECT_EQ(error_of("--3"), "test.cal:1:2: syntax error: a number, a name or '(' expected, but '-' found");
    EXPECT_EQ(error_of("1", "a 3;"), "test.cal:1:3: syntax error: '=' or ':' expected, but '3' found");
    EXPECT_EQ(error_of("1", "a = 3 b = 4"), "test.cal:1:7: syntax error: ';' expected, but 'b' found");
    EXPECT_EQ(error_of("1", "3 = a;"),
              "test.cal:1:1: syntax error: the name of a variable or function expected, but '3' found");
    EXPECT_EQ(error_of("1", "f(x, 2) = x;"),
              "test.cal:1:6: syntax error: the name of a parameter expected, but '2' found");
    EXPECT_EQ(error_of("1", "$1 = 3;"),
              "test.cal:1:1: syntax error: the name of a variable or function expected, but '$' found");
    EXPECT_EQ(error_of("$x"), "test.cal:1:2: syntax error: the number of a channel expected, but 'x' found");
}

TEST(Errors, BadNumbersAndOpenComments) {
    EXPECT_EQ(error_of("2e"), "test.cal:1:3: the exponent of a number is missing");
    EXPECT_EQ(error_of("1 + ."), "test.cal:1:5: a lone '.' is no number");
    EXPECT_EQ(error_of("1", "a = 1;\n{ open { } \n"), "test.cal:2:1: comment is never closed ('}' expected)");
}

TEST(Errors, BadConstantsAreRefused) {
    EXPECT_EQ(error_of("sqrt(-1)"), "test.cal:1:1: bad constant: sqrt(): domain error");
    EXPECT_EQ(error_of("$1/0"), "test.cal:1:3: division by the constant zero");
    EXPECT_EQ(error_of("(-8)^.5"), "test.cal:1:5: bad constant: illegal power");
    EXPECT_EQ(error_of("k", "k : $1;"),
              "test.cal:1:1: channel $1 used in a constant expression (define it with '=', not ':')");
}

TEST(Errors, UndefinedNamesGetAHint) {
    EXPECT_EQ(error_of("wal_paint", "wall_paint = 3;"),
              "test.cal:1:1: undefined variable \"wal_paint\" (did you mean \"wall_paint\"?)");
    EXPECT_EQ(error_of("1 + sgrt(v)", "v = 3;"),
              "test.cal:1:5: undefined function \"sgrt\" (did you mean \"sqrt\"?)");
    EXPECT_EQ(error_of("zork"), "test.cal:1:1: undefined variable \"zork\"");
    EXPECT_EQ(error_of("sin"), "test.cal:1:1: \"sin\" is a function and needs arguments here");
}

TEST(Errors, CallsThatCannotWork) {
    EXPECT_EQ(error_of("f(1)", "f(a, b) = a + b;"), "test.cal:1:15: f(): too few arguments");
    EXPECT_EQ(error_of("atan2(v)", "v = 1;"), "test.cal:1:1: atan2(): too few arguments");
    EXPECT_EQ(error_of("apply(3 + v, 1)", "v = 1; apply(f, x) = f(x);"),
              "test.cal:1:22: apply(): argument 1 is not a function");
    EXPECT_EQ(error_of("x", "x = y + 1; y = x;"), "test.cal:1:16: variable \"x\" depends on itself");
}

TEST(Errors, EndlessRecursionIsAnError) {
    EXPECT_EQ(error_of("f(1)", "f(x) = f(x + 1);"), "endless recursion in f() (calls are 8001 deep)");
    EXPECT_NE(error_of("h(h)", "h(f) = f(f);"), "");
    EXPECT_NE(error_of("v", "v = f(1); f(x) = v + x;"), "");
    EXPECT_NE(error_of("f(1)", "f(x) = 1 + g(f(x)); g(x) = x;"), "");
}

TEST(Errors, MissingRealArgumentsNameTheirPrimitive) {
    Library library = make_ray_library();
    const ExprId id = library.compile("A5", test_text);
    Evaluator evaluator(library.link());
    const double reals[] = {1, 2, 3};
    const Location scene{"sky.rad", 7, 0};
    Host host;
    host.reals = reals;
    host.owner = "brightfunc \"sky\"";
    host.where = &scene;
    try {
        evaluator.evaluate(id, host);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "sky.rad:7: brightfunc \"sky\": missing real argument 5 (there are 3)");
    }
}

TEST(Errors, DeepNestingIsRefusedAndNotCrashed) {
    EXPECT_NE(error_of(std::string(100000, '(')), "");
    std::string sum = "1", power = "2";
    for (int i = 0; i < 100000; ++i) sum += "+x", power += "^x";
    EXPECT_NE(error_of(sum), "");
    EXPECT_NE(error_of(power), "");
    std::string chain = "v0 = $1;";
    for (int i = 1; i < 50000; ++i) chain += "v" + std::to_string(i) + "=v" + std::to_string(i - 1) + "+1;";
    EXPECT_NE(error_of("v49999", chain), "");
}

TEST(Errors, FunctionsThatDoubleAtEachLevelDoNotExplode) {
    std::string chain = "f0(x) = x*$1;";
    for (int i = 1; i < 60; ++i) {
        const std::string before = "f" + std::to_string(i - 1);
        chain += "f" + std::to_string(i) + "(x) = " + before + "(x) + " + before + "(x + 1);";
    }
    Library library;
    library.define(chain, test_text);
    library.compile("f59(1)", test_text);
    library.link();  // evaluation would take 2^59 calls, as the text asks
}

TEST(Errors, AFileThatIsMissingIsNamed) {
    Library library;
    EXPECT_THROW(library.load_file("no such file.cal"), Error);
}

}  // namespace
}  // namespace infra::cal
