// Caching within a clock, functions called from outside, and threads.
#include "cal/evaluator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "evaluate.h"

namespace infra::cal {
namespace {

TEST(Evaluator, AVariableIsEvaluatedOncePerClock) {
    Library library;
    library.define("v = sqrt($1);", test_text);
    const ExprId sum = library.compile("v + v*v", test_text);
    const ExprId other = library.compile("if(v - 2, v, 0) + if(v - 1, 3*v, v)", test_text);
    Evaluator evaluator(library.link());
    CountingHost world({0, 9});
    EXPECT_EQ(evaluator.evaluate(sum, world.host), 12);
    EXPECT_EQ(evaluator.evaluate(other, world.host), 12);
    EXPECT_EQ(evaluator.evaluate(sum, world.host), 12);
    EXPECT_EQ(world.questions, 1);
    world.values[1] = 16;
    EXPECT_EQ(evaluator.evaluate(sum, world.host), 12);  // still the old clock
    evaluator.next_clock();
    EXPECT_EQ(evaluator.evaluate(sum, world.host), 20);
    EXPECT_EQ(evaluator.evaluate(other, world.host), 16);
    EXPECT_EQ(world.questions, 2);
}

TEST(Evaluator, ArgumentsAreEvaluatedOnceAndOnlyIfNeeded) {
    Library library;
    library.define("cube(x) = x*x*x; first(a, b) = if(1, a, b);", test_text);
    const ExprId cube = library.compile("cube($1 + 1)", test_text);
    const ExprId first = library.compile("first(5, $1)", test_text);
    Evaluator evaluator(library.link());
    CountingHost world({0, 2});
    EXPECT_EQ(evaluator.evaluate(cube, world.host), 27);
    EXPECT_EQ(world.questions, 1);
    EXPECT_EQ(evaluator.evaluate(first, world.host), 5);
    EXPECT_EQ(world.questions, 1);
}

TEST(Evaluator, AValueNeededOnSomePathsIsComputedOnThoseAlone) {
    Library library;
    library.define("v = sqrt($2 + $3);", test_text);
    const ExprId id = library.compile("if($1, v, 1) + if($1, v*v, 2)", test_text);
    Evaluator evaluator(library.link());
    CountingHost world({0, 1, 4, 5});
    EXPECT_EQ(evaluator.evaluate(id, world.host), 12);
    EXPECT_EQ(world.questions, 3);
    world.values[1] = -1;
    evaluator.next_clock();
    EXPECT_EQ(evaluator.evaluate(id, world.host), 3);
    EXPECT_EQ(world.questions, 4);
}

TEST(Evaluator, FunctionsCanBeCalledFromOutside) {
    Library library = make_ray_library();
    library.define("lobe(x, y, om) = if(om - 1, x, y)*Dz;", test_text, "c");
    const ExprId lobe = library.compile_function("lobe", 3, test_text, "c");
    const ExprId noise = library.compile_function("noise3", 3, test_text);
    const ExprId missing = library.compile_function("lobe", 2, test_text, "c");
    Evaluator evaluator(library.link());
    CountingHost world({0, 0, 0, 10});
    const double high[] = {3, 4, 2}, low[] = {3, 4, 0}, two[] = {3, 4};
    EXPECT_EQ(evaluator.evaluate(lobe, high, world.host), 30);
    EXPECT_EQ(evaluator.evaluate(lobe, low, world.host), 40);
    const double point[] = {1.2, 3.4, 5.6};
    EXPECT_NEAR(evaluator.evaluate(noise, point, world.host), -.5299883, 1e-7);
    EXPECT_THROW(evaluator.evaluate(missing, two, world.host), Error);
}

TEST(Evaluator, LinkingAgainKeepsIds) {
    Library library;
    const ExprId first = library.compile("1 + 1", test_text);
    const Program before = library.link();
    const ExprId second = library.compile("x", test_text);
    library.define("x = 5;", test_text);
    Evaluator old_one(before), new_one(library.link());
    EXPECT_EQ(old_one.evaluate(first, Host{}), 2);
    EXPECT_EQ(new_one.evaluate(first, Host{}), 2);
    EXPECT_EQ(new_one.evaluate(second, Host{}), 5);
}

TEST(Evaluator, OneProgramServesManyThreads) {
    Library library = make_ray_library();
    library.define("fib(n) = if(n - 1.5, fib(n - 1) + fib(n - 2), n); v = sq(Dx) + turbulence(Dx, 2, 3, .1);",
                   test_text);
    const ExprId id = library.compile("v + v*fib(5 + Dx)", test_text);
    const Program program = library.link();
    const auto run = [&](int start, std::vector<double>& results) {
        Evaluator evaluator(program);
        for (int i = 0; i < 2000; ++i) {
            CountingHost world({0, static_cast<double>((i + start) % 5)});
            evaluator.next_clock();
            results.push_back(evaluator.evaluate(id, world.host));
        }
    };
    std::vector<double> one, two, again;
    std::thread a([&] { run(0, one); }), b([&] { run(5, two); });
    a.join();
    b.join();
    run(0, again);
    EXPECT_EQ(one, again);
    EXPECT_EQ(two, again);
}

}  // namespace
}  // namespace infra::cal
