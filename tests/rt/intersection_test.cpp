// What a ray hits: the hierarchy against a test of every shape, hits against the equations of the shapes.
#include <gtest/gtest.h>

#include "random_shapes.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::Dice;
using test::random_shapes;
using test::text_of;

HitState test_every_shape(const CompiledScene& scene, int count, const Vec3& origin, const Vec3& direction) {
    HitState nearest;
    for (int surface = 0; surface < count; ++surface) {
        HitState state;
        if (scene.geometry().intersect_one(scene.geometry().shape_of(surface), origin, direction, state) &&
            state.distance < nearest.distance)
            nearest = state;
    }
    return nearest;
}

class RandomShapes : public testing::Test {
  protected:
    void compare(const Vec3& origin, const Vec3& direction) {
        const HitState expected = test_every_shape(scene_.compiled(), shape_count, origin, direction);
        const HitState found = scene_.nearest(origin, direction);
        ASSERT_EQ(found.surface, expected.surface)
            << "from " << text_of(origin) << "along " << text_of(direction) << ": " << found.distance
            << " and " << expected.distance;
        if (found.surface < 0) return;
        ++hits_;
        EXPECT_EQ(found.distance, expected.distance);
        // and what shadow rays ask
        using View = Geometry::View;
        const Geometry& geometry = scene_.compiled().geometry();
        EXPECT_EQ(geometry.view(origin, direction, found.distance * (1 - 1e-9), {}), View::clear);
        EXPECT_EQ(geometry.view(origin, direction, found.distance + 1e-3, {}), View::blocked);
    }

    static constexpr int shape_count = 2000;
    Dice dice_;
    const std::string text_ = random_shapes(dice_, shape_count);
    test::TracedScene scene_{text_};
    int hits_ = 0;
};

TEST_F(RandomShapes, FromWithin) {
    for (int n = 0; n < 4000; ++n) compare(dice_.point(5), dice_.direction());
    EXPECT_GT(hits_, 2000);
}

TEST_F(RandomShapes, FromOutside) {
    for (int n = 0; n < 3000; ++n) {
        const Vec3 origin = dice_.direction() * 20.0;
        compare(origin, normalize(dice_.point(5) - origin));
    }
    EXPECT_GT(hits_, 2000);
}

TEST_F(RandomShapes, AlongTheAxes) {
    for (int n = 0; n < 3000; ++n) {
        Vec3 direction{0};
        direction[n % 3] = n % 2 ? 1 : -1;
        compare(dice_.point(6), direction);
    }
    EXPECT_GT(hits_, 1000);
}

TEST_F(RandomShapes, FromAMillionUnitsAway) {
    for (int n = 0; n < 3000; ++n) {
        const Vec3 origin = dice_.direction() * 1e6;
        compare(origin, normalize(dice_.point(5) - origin));
    }
    EXPECT_GT(hits_, 2000);
}

// Every hit lies on its shape, within its outline, and its normal is that of the equation.
TEST_F(RandomShapes, HitsLieOnTheirShapes) {
    Scene text;  // the compiled scene need not keep the numbers
    read_rad_text(text, text_, "test.rad", no_warnings());
    for (int n = 0; n < 20'000; ++n) {
        const Vec3 origin = dice_.point(6), direction = dice_.direction();
        const HitState state = scene_.nearest(origin, direction);
        if (state.surface < 0) continue;
        const Vec3 point = origin + direction * state.distance;
        const Vec3 normal = scene_.compiled().geometry().normal(state.shape, point);
        const PrimitiveId id = scene_.compiled().surface(state.surface).primitive;
        const auto a = text.reals(id);
        const auto vec = [&](std::size_t i) { return Vec3{a[i], a[i + 1], a[i + 2]}; };
        EXPECT_NEAR(length(normal), 1, 1e-9);
        EXPECT_EQ(state.front, dot(normal, direction) < 0);
        constexpr double close = 1e-7;
        switch (text.type(id)) {
            case PrimitiveType::sphere:
            case PrimitiveType::bubble:
                EXPECT_NEAR(length(point - vec(0)), a[3], close);
                break;
            case PrimitiveType::ring: {
                EXPECT_NEAR(dot(point - vec(0), normalize(vec(3))), 0, close);
                EXPECT_LE(length(point - vec(0)), a[7] + close);
                EXPECT_GE(length(point - vec(0)), a[6] - close);
                break;
            }
            case PrimitiveType::polygon: {
                EXPECT_NEAR(dot(point - vec(0), normal), 0, close);
                break;
            }
            default: {  // cones
                const Vec3 axis = vec(3) - vec(0);
                const double along = dot(point - vec(0), axis) / dot(axis, axis);
                const double r0 = a[6], r1 = a.size() > 7 ? a[7] : a[6];
                EXPECT_GE(along, -close);
                EXPECT_LE(along, 1 + close);
                EXPECT_NEAR(length(point - vec(0) - axis * along), r0 + (r1 - r0) * along, close);
                const Vec3 radial = point - vec(0) - axis * along;
                const bool outward =
                    text.type(id) == PrimitiveType::cone || text.type(id) == PrimitiveType::cylinder;
                EXPECT_EQ(dot(normal, radial) > 0, outward);
                break;
            }
        }
    }
}

TEST(Shapes, FaceTheSideThatTheirDefinitionSays) {
    const auto front = [](const std::string& shape, const Vec3& origin, const Vec3& direction) {
        test::TracedScene scene("void plastic m 0 0 5 .5 .5 .5 0 0\nm " + shape);
        const HitState state = scene.nearest(origin, direction);
        EXPECT_GE(state.surface, 0) << shape;
        return state.front;
    };
    const Vec3 left{-5, 0, 0}, right{1, 0, 0}, middle{0, 0, 0};
    EXPECT_TRUE(front("sphere s 0 0 4 0 0 0 1", left, right));
    EXPECT_FALSE(front("sphere s 0 0 4 0 0 0 1", middle, right));
    EXPECT_TRUE(front("bubble s 0 0 4 0 0 0 1", middle, right));
    EXPECT_TRUE(front("sphere s 0 0 4 0 0 0 -1", middle, right));  // a negative radius turns it
    EXPECT_TRUE(front("cylinder c 0 0 7 0 0 -1 0 0 1 1", left, right));
    EXPECT_TRUE(front("tube c 0 0 7 0 0 -1 0 0 1 1", middle, right));
    EXPECT_TRUE(front("cone c 0 0 8 0 0 -1 0 0 1 1 .5", left, right));
    EXPECT_TRUE(front("cup c 0 0 8 0 0 -1 0 0 1 1 .5", middle, right));
    EXPECT_TRUE(front("ring r 0 0 8 0 0 0 -1 0 0 0 1", left, right));
    EXPECT_TRUE(
        front("polygon p 0 0 9 0 -1 -1 0 0 1 0 1 -1", left, right));  // counter-clockwise seen from -x
}

}  // namespace
}  // namespace infra
