// rpict -S: a picture for each view that comes in.
#include <gtest/gtest.h>

#include <algorithm>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

constexpr const char* room =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 1 6 4 .5\n"
    "void plastic paint 0 0 5 .5 .4 .3 0 0\n"
    "paint polygon floor 0 0 12 -9 0 -1  9 0 -1  9 18 -1  -9 18 -1\n"
    "paint sphere ball 0 0 4 0 6 0 1\n";

constexpr const char* views =
    "VIEW= -vp 0 0 0 -vh 40 -vv 40\n"
    "no view\n"
    "VIEW= -vp 1 0 0\n"
    "rvu -vp -1 0 0 -vh 80\n";

struct RpictSequence : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("room.rad", room);
        ASSERT_EQ(test::run(folder, "oconv room.rad > room.oct").status, 0);
        folder.write("views", views);
    }
    Outcome run(const std::string& command) { return test::run(folder, command); }
    Picture read(const std::string& name) { return read_picture(folder.path(name)); }
    static std::size_t count(const std::string& text, const std::string& word) {
        std::size_t n = 0;
        for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++n;
        return n;
    }
};

TEST_F(RpictSequence, is_what_single_pictures_are) {
    const Outcome result =
        run("rpict -S 3 -ab 1 -aa 0 -ad 16 -x 48 -y 48 -o f%02d.exr -z f%02d.z room.oct < views");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    const std::string lines[] = {"-vp 0 0 0 -vh 40 -vv 40", "-vp 1 0 0 -vh 40 -vv 40",
                                 "-vp -1 0 0 -vh 80 -vv 40"};
    for (int i = 0; i < 3; ++i) {
        const std::string name = "f0" + std::to_string(3 + i);
        ASSERT_EQ(
            run("rpict -ab 1 -aa 0 -ad 16 -x 48 -y 48 -o one.exr -z one.z " + lines[i] + " room.oct").status,
            0);
        EXPECT_EQ(read(name + ".exr").pixels, read("one.exr").pixels) << name;
        EXPECT_EQ(folder.read(name + ".z"), folder.read("one.z")) << name;
        EXPECT_EQ(read(name + ".exr").header.value("FRAME"), std::to_string(3 + i));
    }
    EXPECT_EQ(read("f05.exr").width, 48);  // each view has its own shape
    EXPECT_LT(read("f05.exr").height, 25);
}

TEST_F(RpictSequence, follows_one_another_on_the_output_as_they_are_done) {
    // The second view comes when the first picture is there: it must not wait in a buffer.
    const Outcome result =
        run("{ head -1 views; for i in $(seq 500); do grep -aq FRAME=1 out && break; sleep .02; done; "
            "test $i -lt 500 || echo stuck >&2; tail -2 views; } | rpict -S 1 -x 16 -y 16 room.oct > out");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    const std::string bytes = folder.read("out");
    EXPECT_EQ(count(bytes, "#?RADIANCE\n"), 3u);
    for (const char* line : {"FRAME=1\n", "FRAME=2\n", "FRAME=3\n"}) EXPECT_EQ(count(bytes, line), 1u);
}

TEST_F(RpictSequence, leaves_pictures_alone_that_are_there) {
    folder.write("f2.hdr", "someone's");
    EXPECT_EQ(run("rpict -S 1 -x 16 -y 16 -o f%d.hdr room.oct < views").err, "");
    EXPECT_EQ(folder.read("f2.hdr"), "someone's");
    EXPECT_EQ(read("f1.hdr").width, 16);
    EXPECT_EQ(read("f3.hdr").width, 16);
    // Two at once share the work and lose nothing.
    EXPECT_EQ(run("for i in 1 2; do rpict -n 1 -S 1 -x 64 -y 64 -ps 1 -o g%d.hdr room.oct < views & done; "
                  "wait")
                  .status,
              0);
    for (const char* name : {"g1.hdr", "g2.hdr", "g3.hdr"}) EXPECT_EQ(read(name).width, 64) << name;
}

TEST_F(RpictSequence, keeps_the_values_of_diffuse_light) {
    folder.write("twice", "VIEW= -vp 0 0 0\nVIEW= -vp 0 0 0\n");
    const std::string log =
        run("rpict -n 1 -t 1000 -S 1 -ab 1 -aa .2 -ad 64 -x 32 -y 32 room.oct < twice > out").err;
    std::vector<long> rays;
    for (std::size_t at = log.find("rpict: "); at != log.npos; at = log.find("rpict: ", at + 1))
        rays.push_back(std::atol(log.c_str() + at + 7));
    ASSERT_EQ(rays.size(), 4u) << log;  // at the start and at the end of each
    EXPECT_LT(rays[3] * 2, rays[1]) << log;
    EXPECT_EQ(count(log, "FRAME 1: -vtv"), 1u) << log;
}

TEST_F(RpictSequence, serves_tiles_that_make_one_picture) {
    // As rpiece asks for them: parts of a view by -vs and -vl, -pa 0, and the sharp picture must be the same.
    const std::string options = "rpict -pj 0 -ps 1 -aa 0 -av .1 .1 .1 ";
    ASSERT_EQ(run(options + "-x 60 -y 60 -vh 40 -vv 40 room.oct > whole.hdr").status, 0);
    std::string tiles;
    View view;
    view.horizontal = view.vertical = 40;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 2; ++y) {
            View tile = view;
            crop_view(tile, x / 3.0, y / 2.0, (x + 1) / 3.0, (y + 1) / 2.0);
            tiles += "VIEW=" + format_view(tile) + "\n";
        }
    folder.write("tiles", tiles);
    ASSERT_EQ(run(options + "-S 0 -S 1 -x 20 -y 30 -pa 0 -pm 0 -o t%d.hdr room.oct < tiles").status, 0);
    const Picture whole = read("whole.hdr");
    int different = 0;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 2; ++y) {
            const Picture tile = read("t" + std::to_string(1 + 2 * x + y) + ".hdr");
            ASSERT_EQ(tile.width, 20);
            ASSERT_EQ(tile.height, 30);
            for (int column = 0; column < 20; ++column)
                for (int row = 0; row < 30; ++row)
                    for (int c = 0; c < 3; ++c)
                        different +=
                            tile.at(column, row)[c] != whole.at(20 * x + column, 30 * (1 - y) + row)[c];
        }
    EXPECT_LE(different, 3 * 60 * 60 / 500);  // views are written with 5 to 7 digits
}

TEST_F(RpictSequence, ends_with_one_line_when_something_is_wrong) {
    const auto complaint = [&](const std::string& arguments) {
        const Outcome result = run("rpict -x 4 -y 4 " + arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        return result.err;
    };
    EXPECT_NE(complaint("-S 1 < room.oct").find("missing octree argument"), std::string::npos);
    EXPECT_NE(complaint("-S 1 -o p.hdr room.oct < views").find("put %d into the name"), std::string::npos);
    EXPECT_NE(complaint("-S 4 -r 3 -o p%d.hdr room.oct < views").find("recover frame less than start frame"),
              std::string::npos);
    EXPECT_NE(complaint("-S 1 -r 3 room.oct < views").find("missing output file"), std::string::npos);
    EXPECT_NE(complaint("-S 1 -r 9 -o p%d.hdr room.oct < views").find("unexpected EOF on view input"),
              std::string::npos);
    folder.write("bad", "VIEW= -vp 1 0 0\n\nVIEW= -vp 1 0\n");
    EXPECT_NE(complaint("-S 1 -o q%d.hdr room.oct < bad").find("standard input:3: bad view option '-vp'"),
              std::string::npos);
    EXPECT_TRUE(folder.has("q1.hdr"));
    EXPECT_FALSE(folder.has("q2.hdr"));
}

TEST_F(RpictSequence, without_views_makes_nothing) {
    const Outcome result = run("rpict -S 1 room.oct < /dev/null");
    EXPECT_EQ(result.status, 0);  // as RADIANCE's
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "rpict: warning - no output produced\n");
}

TEST_F(RpictSequence, numbered_from_nought_is_one_picture) {
    EXPECT_EQ(count(run("rpict -S 0 -x 8 -y 8 room.oct < views").out, "#?RADIANCE\n"), 1u);
    EXPECT_EQ(run("rpict -x 8 -y 8 -o p%02d.hdr room.oct").status, 0);
    EXPECT_TRUE(folder.has("p00.hdr"));
}

}  // namespace
}  // namespace infra
