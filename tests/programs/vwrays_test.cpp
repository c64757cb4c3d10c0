// vwrays against the geometry of views, and its rays against rpict's picture.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "command.h"

namespace infra {
namespace {

std::vector<double> numbers_in(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> values;
    for (double value; in >> value;) values.push_back(value);
    return values;
}

TEST(Vwrays, DimensionsFitTheView) {
    const test::Folder folder;
    EXPECT_EQ(test::run(folder, "vwrays -d -vd 0 1 0 -vh 60 -vv 60 -x 100 -y 80").out, "-x 80 -y 80\n");
    EXPECT_EQ(test::run(folder, "vwrays -d -vd 0 1 0 -vh 40 -vv 40 -va 3 -x 8 -y 8").out, "-x 8 -y 8 -ld+\n");
}

TEST(Vwrays, ParallelRaysStandOnARasterFromTheTop) {
    const test::Folder folder;
    const auto rays =
        numbers_in(test::run(folder, "vwrays -vtl -vp 0 0 5 -vd 0 0 -1 -vu 0 1 0 -vh 4 -vv 4 -x 2 -y 2").out);
    const std::vector<double> expected{-1, 1,  5, 0, 0, -1, 1, 1,  5, 0, 0, -1,
                                       -1, -1, 5, 0, 0, -1, 1, -1, 5, 0, 0, -1};
    ASSERT_EQ(rays.size(), expected.size());
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_NEAR(rays[i], expected[i], 1e-5);
}

// Wherever a ray starts on the lens, it meets the others of its pixel at the focal distance.
TEST(Vwrays, RaysThroughALensMeetInFocus) {
    const test::Folder folder;
    for (const char* type : {"-vtv", "-vtl", "-vta"}) {
        const auto rays =
            numbers_in(test::run(folder, std::string("printf '0 0\\n' | vwrays -i -c 200 -pd .5 ") + type +
                                             " -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 20 -vv 20 -x 1 -y 1")
                           .out);
        ASSERT_EQ(rays.size(), 1200u);
        double widest = 0;
        for (std::size_t i = 0; i < rays.size(); i += 6) {
            const double* r = &rays[i];
            const double t = (1 - r[1]) / r[4];
            EXPECT_NEAR(r[0] + t * r[3], 0, 1e-4);
            EXPECT_NEAR(r[2] + t * r[5], 0, 1e-4);
            widest = std::max(widest, std::hypot(r[0], r[2]));
        }
        EXPECT_GT(widest, 0.2);
        EXPECT_LE(widest, 0.25 + 1e-5);
    }
}

TEST(Vwrays, DistancesLeadToThePointsSeen) {
    const test::Folder folder;
    folder.write("s.rad", "void glow g 0 0 4 1 1 1 0 g polygon p 0 0 12 -9 4 -9 9 4 -9 9 4 9 -9 4 9\n");
    const auto outcome =
        test::run(folder,
                  "oconv s.rad > s.oct && rpict -w -vp 0 0 0 -vd 0 1 0 -vh 60 -vv 60 -x 4 -y 4 "
                  "-ps 1 -pj 0 -z s.zbf s.oct > s.hdr && vwrays s.hdr s.zbf");
    const auto rays = numbers_in(outcome.out);
    ASSERT_EQ(rays.size(), 96u) << outcome.err;
    for (std::size_t i = 0; i < rays.size(); i += 6) {
        EXPECT_NEAR(rays[i + 1], 4, 1e-4);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rays[i + c] + rays[i + 3 + c], 0, 1e-4);
    }
}

TEST(Vwrays, BadInputIsRefused) {
    const test::Folder folder;
    folder.write("no.hdr", "#?RADIANCE\n\n-Y 2 +X 2\n");
    folder.write("short.zbf", "abc");
    folder.write("view.hdr",
                 "#?RADIANCE\nVIEW= -vtv -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 40 -vv 40\n\n-Y 2 +X 2\n");
    EXPECT_EQ(test::run(folder, "vwrays no.hdr").err,
              "vwrays: no.hdr: no view in picture (its header has no legal VIEW= line)\n");
    EXPECT_NE(test::run(folder, "vwrays view.hdr short.zbf").err.find("3 bytes are not"), std::string::npos);
    EXPECT_NE(test::run(folder, "echo 1 x | vwrays -i view.hdr").status, 0);
    EXPECT_NE(test::run(folder, "vwrays -fq").status, 0);
}

}  // namespace
}  // namespace infra
