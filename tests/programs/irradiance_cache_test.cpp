// The cache of diffuse interreflection as users meet it: -aa, -af.
#include <gtest/gtest.h>

#include <cmath>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::Folder;

/// A box with an opening to the sky, a ball in it.
constexpr const char* room =
    "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 180\nvoid plastic m 0 0 5 .6 .5 .4 0 0\n"
    "m polygon floor 0 0 12 0 0 0 3 0 0 3 3 0 0 3 0\nm polygon w 0 0 12 0 0 0 0 3 0 0 3 2 0 0 2\n"
    "m polygon e 0 0 12 3 0 0 3 0 2 3 3 2 3 3 0\nm polygon n 0 0 12 0 3 0 3 3 0 3 3 2 0 3 2\n"
    "m polygon roof 0 0 12 0 1 2 0 3 2 3 3 2 3 1 2\nm sphere ball 0 0 4 1.5 2 .4 .4\n";

struct CachePrograms : testing::Test {
    Folder folder;
    const std::string render = "rpict -w- -vp 1.5 -1 1 -x 24 -y 24 -ps 1 -ab 2 -aa .2 -ad 100 -as 0 ";

    void SetUp() override {
        folder.write("scene.rad", room);
        ASSERT_EQ(run("oconv scene.rad > scene.oct").status, 0);
    }
    test::Outcome run(const std::string& command) const { return test::run(folder, command); }
    double mean(const std::string& picture) const {
        double sum = 0;
        const Picture read = read_picture(folder.path(picture));
        for (const float v : read.pixels) sum += static_cast<double>(v);
        return sum / static_cast<double>(read.pixels.size());
    }
};

TEST_F(CachePrograms, OneThreadMakesTheSamePictureTwice) {
    ASSERT_EQ(run(render + "-n 1 scene.oct > a.hdr && " + render + "-n 1 scene.oct > b.hdr").status, 0);
    const std::string a = folder.read("a.hdr"), b = folder.read("b.hdr");
    EXPECT_TRUE(a == b);
}

TEST_F(CachePrograms, ThreadsAgreeInTheMeanAndWithEveryHemisphereComputed) {
    ASSERT_EQ(run(render + "-n 1 scene.oct > a.hdr && " + render + "-n 3 scene.oct > b.hdr && " + render +
                  "-aa 0 scene.oct > c.hdr")
                  .status,
              0);
    EXPECT_NEAR(mean("b.hdr") / mean("a.hdr"), 1, 0.02);
    EXPECT_NEAR(mean("c.hdr") / mean("a.hdr"), 1, 0.03);
}

TEST_F(CachePrograms, AFileIsMadeAndUsedAgain) {
    ASSERT_EQ(run(render + "-af a.amb scene.oct > a.hdr").status, 0);
    const std::string first = folder.read("a.amb");
    EXPECT_TRUE(first.starts_with("#?RADIANCE\nrpict -av 0 0 0 -aw 0 -ab 2 -aa 0.2 -ad 100 -as 0 -ar 64 "));
    EXPECT_GT(first.size(), 67u * 30);
    ASSERT_EQ(run(render + "-af a.amb scene.oct > b.hdr").status, 0);
    const std::string second = folder.read("a.amb");
    EXPECT_TRUE(second.starts_with(first));
    EXPECT_LT(second.size(), 1.3 * first.size());
    EXPECT_NEAR(mean("b.hdr") / mean("a.hdr"), 1, 0.02);
}

TEST_F(CachePrograms, ProgramsThatRunAtOnceShareAFile) {
    ASSERT_EQ(
        run(render + "-af a.amb scene.oct > a.hdr & " + render + "-af a.amb scene.oct > b.hdr & wait").status,
        0);
    const auto outcome = run("echo 1.5 2.9 1 0 1 0 | rtrace -h -ab 2 -aa .2 -af a.amb scene.oct");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(CachePrograms, OtherFilesAreRefusedAndLeftAlone) {
    const auto outcome = run(render + "-af scene.rad scene.oct > a.hdr");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("scene.rad: this is no ambient file"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.read("scene.rad"), room);
    EXPECT_EQ(folder.read("a.hdr"), "");
}

TEST_F(CachePrograms, WithoutInterpolationTheFileIsNotOpened) {
    const auto outcome = run("rpict -x 2 -y 2 -ab 1 -ad 4 -as 0 -aa 0 -af a.amb scene.oct > a.hdr");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("zero ambient accuracy so \"a.amb\" not opened"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(folder.has("a.amb"));
}

}  // namespace
}  // namespace infra
