// The hierarchy loses nothing: hit for hit what a test of every shape in double precision finds, whichever
// kernel walks. INFRADIANCE_RAYS sets the number of rays for each scene (50 000).
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "random_shapes.h"
#include "scene_pieces.h"

namespace infra {
namespace {

using test::Dice;
using test::random_polygon;
using test::text_of;
using test::words;

const std::string materials =
    "void plastic m 0 0 5 .5 .5 .5 0 0\n"
    "void plastic other 0 0 5 .5 .5 .5 0 0\n";

long ray_count() {
    const char* const wanted = std::getenv("INFRADIANCE_RAYS");
    return wanted ? std::atol(wanted) : 50'000;
}

// Shapes alone: the modifiers only say which of two surfaces in the same place wins.
class Shapes {
  public:
    explicit Shapes(const std::string& text) {
        read_rad_text(scene_, materials + text, "test.rad", no_warnings());
        for (PrimitiveId id = 0; id < scene_.size(); ++id) {
            if (!scene_.type_info(id).is_geometry()) {
                table_.finishes.push_back({.primitive = id, .material = &opaque_});
                continue;
            }
            table_.surfaces.push_back({.primitive = id, .finish = scene_.modifier(id)});
            geometry_.add(scene_, id, static_cast<int>(table_.surfaces.size()) - 1);
        }
        geometry_.build();
        for (int surface = 0; surface < static_cast<int>(table_.surfaces.size()); ++surface)
            if (geometry_.shape_of(surface) != Geometry::no_shape)
                shapes_.push_back(geometry_.shape_of(surface));
    }

    Geometry& geometry() { return geometry_; }
    HitState test_every_shape(const Vec3& origin, const Vec3& direction) const {
        HitState state;
        for (const ShapeRef shape : shapes_) geometry_.intersect_one(shape, origin, direction, state);
        return state;
    }
    /// A corner, centre or end of one of the shapes.
    Vec3 place(Dice& dice) const {
        const auto& surfaces = table_.surfaces;
        const auto n = static_cast<std::size_t>(dice.between(0, static_cast<double>(surfaces.size())));
        const auto a = scene_.reals(surfaces[n].primitive);
        const bool polygon = scene_.type(surfaces[n].primitive) == PrimitiveType::polygon;
        const std::size_t first = polygon ? 3 * (a.size() / 6) : 0;
        return {a[first], a[first + 1], a[first + 2]};
    }

  private:
    MaterialTraits opaque_{.name = "opaque", .blocks_light = true};
    Scene scene_;
    SurfaceTable table_;
    Geometry geometry_{table_};
    std::vector<ShapeRef> shapes_;
};

// Rays from the box and from far away; anywhere, along the axes and to corners.
void compare(const std::string& text) {
    Shapes shapes(text);
    Geometry& geometry = shapes.geometry();
    const Bounds box = geometry.bounds();
    const Vec3 size = box.hi - box.lo;
    Dice dice;
    long hits = 0;
    for (long n = 0; n < ray_count(); ++n) {
        Vec3 origin = box.lo + Vec3{size.x * dice.between(0, 1), size.y * dice.between(0, 1),
                                    size.z * dice.between(0, 1)};
        if (n % 5 == 0) origin = (box.lo + box.hi) * 0.5 + dice.direction() * (length(size) * 100);
        Vec3 direction = dice.direction();
        if (n % 2 == 0) direction = normalize(shapes.place(dice) - origin + dice.point(1e-3 * (n % 3)));
        if (n % 11 == 0) {
            direction = Vec3{0};
            direction[static_cast<int>(n % 3)] = n % 2 ? 1 : -1;
        }
        const HitState expected = shapes.test_every_shape(origin, direction);
        hits += expected.surface >= 0;
        for (const BvhKernel kernel : {portable_bvh_kernel(), best_bvh_kernel()}) {
            geometry.use(kernel);
            HitState found;
            geometry.intersect(origin, direction, {}, found);
            ASSERT_EQ(found.surface, expected.surface)
                << "ray " << n << " from " << text_of(origin) << "along " << text_of(direction) << ": "
                << found.distance << " and " << expected.distance;
            ASSERT_EQ(found.distance, expected.distance);
            ASSERT_EQ(found.front, expected.front);
        }
    }
    EXPECT_GT(hits, ray_count() / 20);
}

TEST(Hierarchy, EveryShape) {
    Dice dice;
    compare(test::random_shapes(dice, 300));
}

TEST(Hierarchy, CoincidentSurfaces) {
    Dice dice;
    std::string text;
    for (int n = 0; n < 40; ++n) {
        const std::string polygon = random_polygon(dice, dice.point(1), 3 + n % 3);
        const std::string ring =
            words("ring r 0 0 8", text_of(dice.point(1)), text_of(dice.direction()), 0, 0.4, "\n");
        for (const char* modifier : {"m", "other", "m"})
            text += modifier + polygon.substr(1) + modifier + std::string(" ") + ring;
    }
    compare(text);
}

TEST(Hierarchy, Slivers) {
    Dice dice;
    std::string text;
    for (int n = 0; n < 200; ++n) {
        const Vec3 a = dice.point(3), along = dice.direction();
        const Vec3 aside = cross(along, dice.direction()) * std::pow(10.0, -dice.between(0, 10));
        text += words("m polygon p 0 0 9", text_of(a), text_of(a + along * 2.0), text_of(a + along + aside),
                      "\n");
    }
    compare(text);
}

TEST(Hierarchy, HugeAndTiny) {
    Dice dice;
    std::string text =
        "m polygon ground 0 0 9 -1e5 -1e5 -.3 2e5 -1e5 -.3 0 1e5 -.3\nm sphere sky 0 0 4 0 0 0 1e5\n";
    for (int n = 0; n < 150; ++n) {
        const Vec3 center = dice.point(0.3);
        std::string corners;
        for (int k = 0; k < 3; ++k) corners += text_of(center + dice.point(0.02));
        text += n % 3 ? words("m polygon p 0 0 9", corners, "\n")
                      : words("m sphere s 0 0 4", text_of(center), 0.02, "\n");
    }
    compare(text);
}

TEST(Hierarchy, ConcavePolygons) {
    Dice dice;
    std::string text;
    for (int n = 0; n < 60; ++n) text += random_polygon(dice, dice.point(1), 12 + n % 20);
    compare(text);
}

// Many triangles and rays to their corners.
TEST(Hierarchy, Landscape) {
    constexpr int size = 20;  // more than are all looked at when a range is split
    Dice dice;
    Vec3 corner[size + 1][size + 1];
    for (int i = 0; i <= size; ++i)
        for (int k = 0; k <= size; ++k)
            corner[i][k] = {i + dice.between(0, 0.6), k + dice.between(0, 0.6), dice.between(0, 0.5)};
    std::string text;
    for (int i = 0; i < size; ++i)
        for (int k = 0; k < size; ++k)
            for (const auto& [a, b] : {std::pair{corner[i + 1][k], corner[i + 1][k + 1]},
                                       {corner[i + 1][k + 1], corner[i][k + 1]}})
                text += words("m polygon p 0 0 9", text_of(corner[i][k]), text_of(a), text_of(b), "\n");
    compare(text);
}

TEST(Hierarchy, NoShapeAndOne) {
    Shapes none("");
    HitState state;
    none.geometry().intersect({0, 0, 0}, {0, 0, 1}, {}, state);
    EXPECT_EQ(state.surface, -1);
    Shapes one("m polygon p 0 0 9 0 0 1 1 0 1 0 1 1\n");
    one.geometry().intersect({0.2, 0.2, 0}, {0, 0, 1}, {}, state);
    EXPECT_EQ(state.surface, 0);
    EXPECT_EQ(state.distance, 1);
}

}  // namespace
}  // namespace infra
