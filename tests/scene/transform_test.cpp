#include "scene/transform.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

namespace infra {
namespace {

Transform transform_of(const std::string& text, std::size_t expected_words = std::string::npos) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    Transform transform;
    const std::size_t read = parse_transform(words, transform);
    EXPECT_EQ(read, expected_words == std::string::npos ? words.size() : expected_words) << text;
    return transform;
}

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Transform, EachOption) {
    const Vec3 p(1, 2, 3);
    const double c = std::cos(std::numbers::pi / 6), s = 0.5;
    expect_near(transform_of("-t 1 -2 .5").point(p), {2, 0, 3.5});
    expect_near(transform_of("-t 1 -2 .5").vector(p), p);
    expect_near(transform_of("-rx 30").point(p), {1, 2 * c - 3 * s, 2 * s + 3 * c});
    expect_near(transform_of("-ry 30").point(p), {c + 3 * s, 2, 3 * c - s});
    expect_near(transform_of("-rz 30").point(p), {c - 2 * s, 2 * c + s, 3});
    expect_near(transform_of("-s 2").point(p), {2, 4, 6});
    expect_near(transform_of("-mx").point(p), {-1, 2, 3});
    expect_near(transform_of("-my").point(p), {1, -2, 3});
    expect_near(transform_of("-mz").point(p), {1, 2, -3});
}

TEST(Transform, OptionsActInOrder) {
    expect_near(transform_of("-t 1 0 0 -rz 90").point({0, 0, 0}), {0, 1, 0});
    expect_near(transform_of("-rz 90 -t 1 0 0").point({1, 0, 0}), {1, 1, 0});
    expect_near(transform_of("-s 3 -t 1 1 1").point({1, 1, 1}), {4, 4, 4});
}

TEST(Transform, RepetitionReachesToTheNext) {
    expect_near(transform_of("-i 3 -t 1 0 0").point({0, 0, 0}), {3, 0, 0});
    expect_near(transform_of("-t 0 0 5 -i 2 -t 1 0 0 -i 1 -s 2").point({0, 0, 0}), {4, 0, 10});
    expect_near(transform_of("-i 0 -t 1 0 0").point({0, 0, 0}), {0, 0, 0});
    expect_near(transform_of("-i 1000000000 -t 1 0 0").point({0, 0, 0}), {1e9, 0, 0});
    expect_near(transform_of("-i 9 -rz 10").point({1, 0, 0}), {0, 1, 0});
}

TEST(Transform, ScaleAndMirroring) {
    EXPECT_EQ(transform_of("-s 2 -s 3").scale, 6);
    EXPECT_FALSE(transform_of("-mx -my").mirrors());
    EXPECT_TRUE(transform_of("-mx -s 2").mirrors());
    EXPECT_EQ(transform_of("-mx -s 2").magnification(), 2);
}

TEST(Transform, StopsAtWhatIsNone) {
    transform_of("-t 1 2", 0);
    transform_of("-rx 5 -t 1 2 x", 2);
    transform_of("-s 0", 0);
    transform_of("-i many", 0);
    transform_of("-rx 5 file.rad -rx 5", 2);
    transform_of("-rw 5", 0);
}

TEST(Transform, InverseUndoes) {
    const Transform t = transform_of("-rx 10 -s 3 -t 1 2 3 -my -rz 70 -i 2 -ry 20 -t .1 .2 .3");
    expect_near((t * t.inverse()).point({4, -5, 6}), {4, -5, 6});
    expect_near(t.inverse().point(t.point({1, 2, 3})), {1, 2, 3});
    EXPECT_NEAR(t.inverse().scale * t.scale, 1, 1e-15);
}

}  // namespace
}  // namespace infra
