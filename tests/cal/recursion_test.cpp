// Functions that lead back to themselves: lazy arguments, functions as arguments, accumulation.
#include <gtest/gtest.h>

#include <cmath>

#include "evaluate.h"

namespace infra::cal {
namespace {

TEST(Recursion, TheUsualExamples) {
    EXPECT_EQ(value_of("fact(10)", "fact(n) = if(n - 1.5, n*fact(n - 1), 1);"), 3628800);
    EXPECT_EQ(value_of("fib(15)", "fib(n) : if(n - 1.5, fib(n - 1) + fib(n - 2), n);"), 610);
    EXPECT_EQ(value_of("gcd(84, 36)", "gcd(a, b) = if(b - .5, gcd(b, a - b*floor(a/b)), a);"), 12);
    EXPECT_EQ(
        value_of("even(8)", "even(n) = if(n - .5, odd(n - 1), 1); odd(n) = if(n - .5, even(n - 1), 0);"), 1);
}

TEST(Recursion, FunctionsArePassedThrough) {
    const char* definitions =
        "fold(f, n) = if(n - .5, f(n, fold(f, n - 1)), 0);"
        "plus(a, b) = a + b;  peak(a, b) = if(a - b, a, b);";
    EXPECT_EQ(value_of("fold(plus, 10)", definitions), 55);
    EXPECT_EQ(value_of("fold(peak, 7)", definitions), 7);
    EXPECT_EQ(value_of("fold(plus, 4)*fold(atan2, 0)", definitions), 0);
}

TEST(Recursion, ArgumentsStayLazy) {
    // The second argument would recurse for ever or fail if it were computed.
    EXPECT_EQ(value_of("f(5, nosuch)", "f(n, x) = if(n, f(n - 1, x), 7);"), 7);
    EXPECT_EQ(value_of("f(3, 1)", "f(n, x) = if(n, f(n - 1, g(x)), 7); g(x) = g(x);"), 7);
    double x = 1;
    for (int n = 0; n < 3; ++n) x = std::sqrt(x) + x / 2;
    EXPECT_EQ(value_of("f(3, 1)", "f(n, x) = if(n - .5, f(n - 1, sqrt(x) + x/2), x);"), x);
}

TEST(Recursion, ALazyArgumentIsComputedOnce) {
    Library library;
    library.define("f(n, x) = if(n - .5, f(n - 1, x) + if(n - 1.5, x, 0) + x, x*0 + x);", test_text);
    const ExprId id = library.compile("f(10, sqrt($1))", test_text);
    Evaluator evaluator(library.link());
    CountingHost world({0, 4});
    EXPECT_EQ(evaluator.evaluate(id, world.host), 2 * (1 + 10 + 9));
    EXPECT_EQ(world.questions, 1);
}

TEST(Recursion, DepthOfThousandsWorks) {
    EXPECT_EQ(value_of("s(5000, 0)", "s(n, a) = if(n - .5, s(n - 1, a + n), a);"), 12502500);
    EXPECT_EQ(value_of("s(5000)", "s(n) = if(n - .5, n + s(n - 1), 0);"), 12502500);
}

TEST(Recursion, LocalValuesSharedByBranchesAreRight) {
    // sqrt(x + n) is used in the condition of one branch and the value of the other, at every level.
    const char* definitions =
        "w(x, n) = sqrt(x + n)*3;"
        "f(x, n) = if(n - .5, if(w(x, n) - 6, w(x, n) + f(x, n - 1), if(x, f(x, n - 1), w(x, n))), 0);";
    double expected = 0;
    for (int n = 1; n <= 6; ++n)
        if (const double w = std::sqrt(2. + n) * 3; w > 6) expected = w + expected;
    EXPECT_DOUBLE_EQ(value_of("f(v, 6)", std::string(definitions) + "v = 2;"), expected);
}

}  // namespace
}  // namespace infra::cal
