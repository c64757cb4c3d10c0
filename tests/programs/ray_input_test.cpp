#include "rt/programs/ray_input.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace infra {
namespace {

struct Given {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::tmpfile(), std::fclose};

    Given(const void* bytes, std::size_t size) {
        std::fwrite(bytes, 1, size, file.get());
        std::rewind(file.get());
    }
    explicit Given(const std::string& text) : Given(text.data(), text.size()) {}
};

TEST(RayInput, reads_text_in_any_layout) {
    const Given given("0 0 5 0 0 -2\n\n1e0\n-.5 +3.\t0\r\n 3 4\n");
    RayInput input(given.file.get(), NumberFormat::text);
    RayRequest ray;
    ASSERT_TRUE(input.next(ray));
    EXPECT_EQ(ray.origin, Vec3(0, 0, 5));
    EXPECT_EQ(ray.direction, Vec3(0, 0, -1));
    EXPECT_EQ(ray.length, 2);
    ASSERT_TRUE(input.next(ray));
    EXPECT_EQ(ray.origin, Vec3(1, -.5, 3));
    EXPECT_EQ(ray.direction, Vec3(0, .6, .8));
    EXPECT_EQ(ray.length, 5);
    EXPECT_FALSE(input.next(ray));
    EXPECT_EQ(input.fault(), "");
}

TEST(RayInput, leaves_a_zero_direction_alone) {
    const Given given("1 2 3 0 0 0");
    RayInput input(given.file.get(), NumberFormat::text);
    RayRequest ray;
    ASSERT_TRUE(input.next(ray));
    EXPECT_EQ(ray.direction, Vec3(0, 0, 0));
    EXPECT_EQ(ray.length, 0);
}

TEST(RayInput, stops_at_what_is_no_ray) {
    const std::pair<std::string, std::string> cases[] = {
        {"1 2 3 0 0 x 1", "'x' is no number"},
        {"1 2 3 0 0", "it ends within a ray"},
        {"nan 2 3 0 0 1", "'nan' is no number"},
        {"1 2 3 0 0 1e999", "'1e999' is no number"},
        {std::string(100, 'x') + " 2 3 0 0 1", "'" + std::string(60, 'x') + "' is no number"},
        {std::string(6, '\0'), "'" + std::string(6, '\0') + "' is no number"},
    };
    for (const auto& [text, fault] : cases) {
        const Given given(text);
        RayInput input(given.file.get(), NumberFormat::text);
        RayRequest ray;
        const bool first = input.next(ray);
        EXPECT_FALSE(first && input.next(ray)) << text;
        EXPECT_EQ(input.fault(), fault) << text;
    }
}

TEST(RayInput, reads_raw_numbers) {
    const float floats[] = {1, 2, 3, 0, 4, 0, 9, 9};
    const Given given_floats(floats, sizeof floats);
    RayInput input(given_floats.file.get(), NumberFormat::floats);
    RayRequest ray;
    ASSERT_TRUE(input.next(ray));
    EXPECT_EQ(ray.origin, Vec3(1, 2, 3));
    EXPECT_EQ(ray.direction, Vec3(0, 1, 0));
    EXPECT_FALSE(input.next(ray));
    EXPECT_EQ(input.fault(), "it ends within a ray");

    const double doubles[] = {0.1, 0, 0, 1, 0, 0};
    const Given given_doubles(doubles, sizeof doubles);
    RayInput input_doubles(given_doubles.file.get(), NumberFormat::doubles);
    ASSERT_TRUE(input_doubles.next(ray));
    EXPECT_EQ(ray.origin.x, 0.1);
    EXPECT_FALSE(input_doubles.next(ray));
    EXPECT_EQ(input_doubles.fault(), "");
}

TEST(RayInput, refuses_raw_numbers_that_are_not_finite) {
    const float floats[] = {1, 2, 3, 0, std::numeric_limits<float>::infinity(), 0};
    const Given given(floats, sizeof floats);
    RayInput input(given.file.get(), NumberFormat::floats);
    RayRequest ray;
    EXPECT_FALSE(input.next(ray));
    EXPECT_EQ(input.fault(), "it is not finite");
}

}  // namespace
}  // namespace infra
