// The rules of the language, by expressions whose value follows from them.
#include <gtest/gtest.h>

#include <cmath>

#include "evaluate.h"

namespace infra::cal {
namespace {

TEST(Language, OperatorsBindAsInRadiance) {
    EXPECT_EQ(value_of("1+2*3"), 7);
    EXPECT_EQ(value_of("8-3-2"), 3);
    EXPECT_EQ(value_of("64/4/2"), 8);
    EXPECT_EQ(value_of("2^3^2"), 512);
    EXPECT_EQ(value_of("-2^2"), 4);  // the sign belongs to the 2
    EXPECT_EQ(value_of("2^-1"), .5);
    EXPECT_EQ(value_of("3-(-2)^2"), -1);
    EXPECT_EQ(value_of("2*-3"), -6);
    EXPECT_EQ(value_of("-(-(4))"), 4);
    EXPECT_EQ(value_of(".5+5.+1.5e1+2E-1"), 20.7);
}

TEST(Language, TheSameHoldsForValuesThatAreNotConstant) {
    const std::string x = "x = $1;";
    CountingHost world({0, 2});
    const auto value = [&](std::string_view expression) {
        Library library;
        library.define(x, test_text);
        const ExprId id = library.compile(expression, test_text);
        return Evaluator(library.link()).evaluate(id, world.host);
    };
    EXPECT_EQ(value("-x^2"), 4);
    EXPECT_EQ(value("x^3^x"), 512);
    EXPECT_EQ(value("x^3"), 8);
    EXPECT_EQ(value("x^.5"), std::pow(2, .5));
    EXPECT_EQ(value("7-x-x"), 3);
    EXPECT_EQ(value("(1-x)*10 + x*3"), -4);
    EXPECT_EQ(value("3*x + 5"), 11);
    EXPECT_EQ(value("max(min(x, 1), -1)"), 1);
    EXPECT_EQ(value("if(1.5 - x, 1.5, if(x - 3, 3, x))"), 2);
    EXPECT_EQ(value("if(5 - x, 5, if(x - 3, 3, x))"), 5);  // bounds the wrong way round: the lower one wins
    EXPECT_EQ(value("if(x*x + x*x, atan2(x, x), 0)"), std::atan2(2, 2));
}

TEST(Language, IfTakesItsFirstBranchAboveZeroOnly) {
    EXPECT_EQ(value_of("if(0, 1, 2)"), 2);
    EXPECT_EQ(value_of("if(-1, 1, 2)"), 2);
    EXPECT_EQ(value_of("if(1e-300, 1, 2)"), 1);
}

TEST(Language, IfIsLazy) {
    EXPECT_EQ(value_of("if(1, 2, nosuch)"), 2);
    EXPECT_EQ(value_of("if(v, nosuch(3), 7)", "v = -1;"), 7);
    EXPECT_EQ(value_of("if(1, 2)"), 2);
    EXPECT_EQ(value_of("unless(1, nosuch)", "unless(a, b) = if(a, 5, b);"), 5);
}

TEST(Language, SelectRoundsItsIndexAndZeroCounts) {
    EXPECT_EQ(value_of("select(n, 5, 6, 7)", "n = 2;"), 6);
    EXPECT_EQ(value_of("select(n, 5, 6, 7)", "n = 1.6;"), 6);
    EXPECT_EQ(value_of("select(n, 5, 6, 7)", "n = 0;"), 3);
    EXPECT_EQ(value_of("select(n, 5, 6)", "n = 4;"), 0);
    EXPECT_EQ(value_of("select(n, 5, 6)", "n = -2;"), 0);
    EXPECT_EQ(value_of("select(n, 5, nosuch)", "n = 1;"), 5);
}

TEST(Language, SelectWithAVaryingIndexJumps) {
    Library library;
    const ExprId id = library.compile("select($1, $2*2, sqrt($2), 9) + $2*2", test_text);
    Evaluator evaluator(library.link());
    const double expected[] = {3 + 32, 32 + 32, 4 + 32, 9 + 32, 0 + 32};
    for (int n = 0; n <= 4; ++n) {
        CountingHost world({0, static_cast<double>(n), 16});
        evaluator.next_clock();
        EXPECT_EQ(evaluator.evaluate(id, world.host), expected[n]) << n;
    }
    EXPECT_EQ(evaluator.fault_count(), 1u);
    EXPECT_EQ(evaluator.last_fault(), "select(): domain error");
}

TEST(Language, MinAndMaxTakeAnyNumberOfArguments) {
    EXPECT_EQ(value_of("min(3, 1, 2)"), 1);
    EXPECT_EQ(value_of("max(3, 1, 5, 2)"), 5);
    EXPECT_EQ(value_of("min(5)"), 5);
}

TEST(Language, OutsideTheirDomainFunctionsGiveZero) {
    for (const char* expression :
         {"sqrt(x)", "log(x)", "acos(x - 1)", "exp(1000*-x)", "1/(x+1)", "x^.5", "0^x", "asin(x*2)"}) {
        Library library;
        library.define("x = $1;", test_text);
        library.set_constant_folding(false);
        const ExprId id = library.compile(expression, test_text);
        Evaluator evaluator(library.link());
        CountingHost world({0, -1});
        EXPECT_EQ(evaluator.evaluate(id, world.host), 0) << expression;
        EXPECT_EQ(evaluator.fault_count(), 1u) << expression;
    }
}

TEST(Language, CommentsNestAndSeparate) {
    EXPECT_EQ(value_of("{a{b}c}5{ }", "{ { first } } f(x) = { here } x; {last}"), 5);
    EXPECT_EQ(error_of("1{ }2"),
              "test.cal:1:5: syntax error: an operator or the end expected, but '2' found");
}

TEST(Language, FunctionsTakeFunctions) {
    const char* definitions =
        "twice(x) = 2*x;  apply(f, x) = f(x);  compose(f, g, x) = f(g(x));  both(f, x) = apply(f, x) + f(1);";
    EXPECT_EQ(value_of("apply(twice, 5)", definitions), 10);
    EXPECT_EQ(value_of("apply(sqrt, 16)", definitions), 4);
    EXPECT_EQ(value_of("compose(sqrt, twice, 8)", definitions), 4);
    EXPECT_EQ(value_of("compose(twice, twice, compose(twice, sqrt, 9))", definitions), 24);
    EXPECT_EQ(value_of("both(twice, 4)", definitions), 10);
}

TEST(Language, MoreArgumentsThanNeededAreIgnored) {
    EXPECT_EQ(value_of("f(1, 2)", "f(x) = x;"), 1);
    EXPECT_EQ(value_of("sin(0, nosuch)"), 0);
}

TEST(Language, DefinitionsMayComeLaterAndReplaceEarlierOnes) {
    EXPECT_EQ(value_of("v", "v = w*w; w = k - 5; k : 3 + 4;"), 4);
    EXPECT_EQ(value_of("g(1)", "f(x) = x + 1; g(x) = f(x)*10; f(x) = x + 2;"), 30);
    EXPECT_EQ(value_of("a", "a = 3; a = 4;"), 4);
}

TEST(Language, ConstantsAreWorkedOutWhereTheyAreRead) {
    EXPECT_EQ(value_of("b", "k : 3; b = k*2; k : 4;"), 6);  // b was read when k was 3
    EXPECT_EQ(value_of("b", "k = 3; b = k*2; k = 4;"), 8);
    EXPECT_EQ(value_of("m", "h(x) : x*x; m : h(3); h(x) : 0;"), 9);
    EXPECT_EQ(value_of("0*nosuch + nosuch*0"), 0);  // the factor of a zero is not even looked up
}

TEST(Language, AVariableMayShareItsNameWithABuiltInFunction) {
    EXPECT_EQ(value_of("sin + sin(0)", "sin = 3;"), 3);
    EXPECT_EQ(value_of("sin(2)", "sin(x) = x*x;"), 4);
}

}  // namespace
}  // namespace infra::cal
