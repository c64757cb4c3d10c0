#include "bsdf/angle_basis.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/disk_square.h"
#include "common/random.h"

namespace infra {
namespace {

TEST(AngleBasis, HasThePatchesOfTheStandard) {
    EXPECT_EQ(standard_angle_basis("LBNL/Klems Full")->patch_count(), 145);
    EXPECT_EQ(standard_angle_basis("lbnl/klems half")->patch_count(), 77);
    EXPECT_EQ(standard_angle_basis("LBNL/Klems Quarter")->patch_count(), 41);
    EXPECT_EQ(standard_angle_basis("LBNL/Klems"), nullptr);
}

TEST(AngleBasis, FillsTheHemisphereAndFindsItsPatchesAgain) {
    RandomStream random(1, 1);
    for (const char* name : {"LBNL/Klems Full", "LBNL/Klems Half", "LBNL/Klems Quarter"}) {
        const AngleBasis& basis = *standard_angle_basis(name);
        double sum = 0;
        for (int patch = 0; patch < basis.patch_count(); ++patch) {
            sum += basis.projected_solid_angle(patch);
            for (int n = 0; n < 20; ++n) {
                const Vec3 d = basis.direction(patch, random.uniform(), random.uniform());
                EXPECT_NEAR(length(d), 1, 1e-12);
                EXPECT_EQ(basis.patch_of(d), patch);
            }
        }
        EXPECT_NEAR(sum, std::numbers::pi, 1e-12);
        EXPECT_EQ(basis.patch_of({0, 0, -1}), -1);
    }
}

TEST(DiskSquare, IsItsOwnInverse) {
    RandomStream random(2, 1);
    for (int n = 0; n < 1000; ++n) {
        const Point2 square{random.uniform(), random.uniform()};
        const Point2 disk = disk_of_square(square), back = square_of_disk(disk);
        EXPECT_LE(disk[0] * disk[0] + disk[1] * disk[1], 1 + 1e-12);
        EXPECT_NEAR(back[0], square[0], 1e-9);
        EXPECT_NEAR(back[1], square[1], 1e-9);
    }
    EXPECT_LT(square_of_disk({1.0000001, 0})[0], 1);
    EXPECT_EQ(square_of_disk({0, 0})[0], 0.5);
}

}  // namespace
}  // namespace infra
