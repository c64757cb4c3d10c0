// Evaluation must not allocate: every operator new of this test program is counted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "evaluate.h"

namespace {
thread_local std::size_t allocations = 0;
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace infra::cal {
namespace {

TEST(Allocation, EvaluationDoesNotAllocate) {
    Library library = make_ray_library();
    library.define(
        "fib(n) = if(n - 1.5, fib(n - 1) + fib(n - 2), n);"
        "lazy(n, x) = if(n - .5, lazy(n - 1, sqrt(x)), x);"
        "v = turbulence(Px, Py, Pz, .1);",
        test_text);
    const ExprId ids[] = {library.compile("fib(12) + v*fnoise3(Px, Py, Pz)", test_text),
                          library.compile("lazy(9, Px) + v", test_text),
                          library.compile("select(A1, Px, sqrt(-Px), arg(2)) + log(Px - 1.5)", test_text)};
    const ExprId function = library.compile_function("hermite", 5, test_text);
    Evaluator evaluator(library.link());
    CountingHost world(std::vector<double>(38, 1.5));
    const double reals[] = {2, 3}, arguments[] = {1, 2, 3, 4, .5};
    world.host.reals = reals;
    const std::size_t before = allocations;
    for (int i = 0; i < 100; ++i) {
        evaluator.next_clock();
        for (const ExprId id : ids) evaluator.evaluate(id, world.host);
        evaluator.evaluate(function, arguments, world.host);
    }
    EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace infra::cal
