// Which definition a name means, with contexts.
#include <gtest/gtest.h>

#include "evaluate.h"

namespace infra::cal {
namespace {

double in_context(Library& library, std::string_view expression, std::string_view context) {
    const ExprId id = library.compile(expression, test_text, context);
    return Evaluator(library.link()).evaluate(id, Host{});
}

TEST(Context, TheInnermostDefinitionIsMeant) {
    Library library;
    library.define("x = 1; y = 10; z = 100;", test_text);
    library.define("x = 2; y = 20;", test_text, "day");
    library.define("x = 3;", test_text, "sky`day");
    EXPECT_EQ(in_context(library, "x + y + z", "sky`day"), 123);
    EXPECT_EQ(in_context(library, "x + y + z", "day"), 122);
    EXPECT_EQ(in_context(library, "x + y + z", ""), 111);
    EXPECT_EQ(in_context(library, "x + y + z", "elsewhere"), 111);
}

TEST(Context, BackQuotesNameContexts) {
    Library library;
    library.define("x = 1;", test_text);
    library.define("x = 2; only = 5;", test_text, "day");
    EXPECT_EQ(in_context(library, "x`day", ""), 2);
    EXPECT_EQ(in_context(library, "x`", "day"), 1);
    EXPECT_EQ(in_context(library, "`only", "day"), 5);
    EXPECT_THROW(in_context(library, "`only", "sky`day"), Error);
}

TEST(Context, ADefinitionNeedNotBeInItsOwnFile) {
    Library library;
    library.define("x`in = 3; f`in(a) = a*4;", test_text);
    EXPECT_EQ(in_context(library, "f(x)", "in"), 12);
}

TEST(Context, ANameIsBoundWhenItIsRead) {
    Library library;
    library.define("sq(x) = x*x;", test_text);
    library.define("before(x) = sq(x); sq(x) = 100; after(x) = sq(x);", test_text, "c");
    EXPECT_EQ(in_context(library, "before(3)", "c"), 9);
    EXPECT_EQ(in_context(library, "after(3)", "c"), 100);
}

TEST(Context, FileNamesBecomeContexts) {
    Library library;
    library.define("x = 7;", test_text, "dir/sky-1");
    EXPECT_EQ(in_context(library, "x`dir_sky_1", ""), 7);
}

TEST(Context, AFunctionFileIsLoadedOnce) {
    Library library = make_ray_library();
    const std::string context = library.load_function_file("skyfuncs/elevsky.cal", test_text);
    EXPECT_EQ(context, "skyfuncs/elevsky");
    EXPECT_TRUE(library.defines_variable("skybr", context));
    EXPECT_FALSE(library.defines_variable("skybr"));
    EXPECT_EQ(library.load_function_file("skyfuncs/elevsky.cal", test_text), context);
    EXPECT_EQ(library.load_function_file(".", test_text), "");
}

TEST(Context, ArityIsKnown) {
    Library library = make_ray_library();
    EXPECT_EQ(library.function_arity("noise3"), 3);
    EXPECT_EQ(library.function_arity("clip_r"), 3);
    EXPECT_EQ(library.function_arity("noop"), 1);
    EXPECT_EQ(library.function_arity("if", "anywhere"), 3);
    EXPECT_EQ(library.function_arity("nosuch"), 0);
}

}  // namespace
}  // namespace infra::cal
