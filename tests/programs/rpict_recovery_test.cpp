// rpict -r and -ro: what a stopped program left is finished.
#include <gtest/gtest.h>

#include <algorithm>

#include "command.h"
#include "common/pictures/picture.h"
#include "rt/programs/partial_frame.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

/// Everything that draws random numbers.
constexpr const char* room =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 1 6 4 .5\n"
    "void plastic paint 0 0 5 .5 .4 .3 .2 .2\n"
    "paint polygon floor 0 0 12 -9 0 -1  9 0 -1  9 18 -1  -9 18 -1\n"
    "paint sphere ball 0 0 4 0 6 0 1\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n";

struct RpictRecovery : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("room.rad", room);
        ASSERT_EQ(test::run(folder, "oconv room.rad > room.oct").status, 0);
    }
    Outcome run(const std::string& command) { return test::run(folder, command); }
    /// Stops a command some time after its first ray; its messages are in "log".
    Outcome stop(const std::string& command, const std::string& seconds) {
        return run("rm -f log; " + command +
                   " 2> log & while ! grep -q rays log && kill -0 $!; do sleep .01; done; sleep " + seconds +
                   "; kill $!; wait $!");
    }
    Picture read(const std::string& name) { return read_picture(folder.path(name)); }
    std::string complaint(const std::string& arguments) {
        const Outcome result = run("rpict -x 4 -y 4 " + arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        return result.err;
    }
};

/// Seconds of work.
constexpr const char* work =
    "rpict -t 1000 -ab 2 -aa 0 -ad 900 -as 0 -x 90 -y 60 -pa 0 -vh 50 -vv 40 -vp .1 .2 .3 ";

TEST_F(RpictRecovery, of_a_stopped_picture_gives_the_same_bits) {
    const std::string rpict = work;
    ASSERT_EQ(run(rpict + "-o whole.exr -z whole.z room.oct").status, 0);
    ASSERT_EQ(stop(rpict + "-n 1 -o p.exr -z p.z room.oct", "0").status, 3) << folder.read("log");
    EXPECT_FALSE(folder.has("p.exr"));
    EXPECT_FALSE(folder.has("p.z"));
    const std::string first = folder.read("p.exr.partial");
    ASSERT_EQ(stop(rpict + "-n 3 -ro p.exr -z p.z room.oct", ".1").status, 3) << folder.read("log");
    EXPECT_GT(folder.read("p.exr.partial").size(), first.size());  // it had gone on
    ASSERT_EQ(run(rpict + "-n 2 -ro p.exr -z p.z room.oct").status, 0);
    EXPECT_EQ(read("p.exr").pixels, read("whole.exr").pixels);
    EXPECT_EQ(folder.read("p.z"), folder.read("whole.z"));
    EXPECT_FALSE(folder.has("p.exr.partial"));
    EXPECT_EQ(read("p.exr").header.value("VIEW"), read("whole.exr").header.value("VIEW"));
}

TEST_F(RpictRecovery, of_a_killed_picture_gives_the_same_bits) {
    // SIGKILL leaves no time to keep anything: what was kept before is there.
    const std::string rpict = work + std::string("-ck .05 ");
    ASSERT_EQ(run(rpict + "-o whole.exr -z whole.z room.oct").status, 0);
    EXPECT_FALSE(folder.has("whole.exr.partial"));
    const Outcome killed =
        run(rpict +
            "-n 1 -o p.exr -z p.z room.oct & while ! [ -e p.exr.partial ] && kill -0 $! 2> "
            "/dev/null; do sleep .01; done; kill -9 $!; wait $!");
    ASSERT_EQ(killed.status, 128 + 9) << killed.err;
    EXPECT_FALSE(folder.has("p.exr"));
    const PartialFrame left = read_partial(folder.path("p.exr.partial"), {});
    EXPECT_GT(std::count(left.frame.traced.begin(), left.frame.traced.end(), 1), 0);
    EXPECT_EQ(left.fingerprint, "");
    ASSERT_EQ(run(rpict + "-ro p.exr -z p.z room.oct").status, 0);
    EXPECT_EQ(read("p.exr").pixels, read("whole.exr").pixels);
    EXPECT_EQ(folder.read("p.z"), folder.read("whole.z"));
    EXPECT_FALSE(folder.has("p.exr.partial"));
}

TEST_F(RpictRecovery, of_the_output_knows_view_and_size) {
    // As rad does it: the picture went to the standard output, and nothing but the file is named afterwards.
    const std::string light = "-ab 2 -aa 0 -ad 900 -as 0 ";
    ASSERT_EQ(run(work + std::string("room.oct > whole.hdr")).status, 0);
    ASSERT_EQ(stop(work + std::string("room.oct > p.unf"), ".05").status, 3);
    EXPECT_NE(folder.read("log").find("finishes the file that its output went to"), std::string::npos);
    ASSERT_EQ(run("rpict " + light + "-ro p.unf room.oct").status, 0);
    EXPECT_EQ(read("p.unf").pixels, read("whole.hdr").pixels);
    EXPECT_EQ(read("p.unf").header.value("PIXASPECT"), read("whole.hdr").header.value("PIXASPECT"));
}

TEST_F(RpictRecovery, of_radiances_scanlines_goes_on_below_them) {
    const std::string light = " -ab 1 -aa 0 -ad 16 -as 0 -ps 1 ";  // every pixel by itself
    ASSERT_EQ(run("rpict -x 40 -y 30 -vp .1 .2 .3" + light + "-z whole.z room.oct > whole.hdr").status, 0);
    const Picture whole = read("whole.hdr");
    const std::string bytes = folder.read("whole.hdr"), depths = folder.read("whole.z");
    const std::size_t start = bytes.find("\n", bytes.find("+X")) + 1;
    for (const double share : {0.0, 0.3, 0.77, 1.0}) {
        const std::size_t kept = start + std::size_t(share * double(bytes.size() - start));
        folder.write("cut.hdr", bytes.substr(0, kept));
        folder.write("cut.z", depths.substr(0, std::size_t(share * double(depths.size()))));
        const Outcome result = run("rpict" + light + "-z cut.z -r cut.hdr -o p.hdr room.oct");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(read("p.hdr").pixels, whole.pixels) << share;
        EXPECT_EQ(read("p.hdr").header.value("VIEW"), whole.header.value("VIEW"));
        EXPECT_FALSE(folder.has("cut.hdr"));  // its work is in the other
        EXPECT_EQ(folder.read("cut.z").size(), depths.size());
        if (share == 0 || share == 1) {
            EXPECT_EQ(folder.read("cut.z"), depths);
        }
    }
    // Scanlines are taken as they are, whatever they hold, also when finishing is stopped too.
    std::string grey = bytes.substr(0, start);
    for (int i = 0; i < 40 * 10; ++i) grey += "\x80\x80\x80\x82";
    folder.write("p.hdr", grey);
    ASSERT_EQ(stop("rpict -t 1000 -ab 2 -aa 0 -ad 9000 -as 0 -ro p.hdr room.oct", "0").status, 3);
    EXPECT_EQ(folder.read("p.hdr"), grey);
    ASSERT_EQ(run("rpict" + light + "-ro p.hdr room.oct").status, 0);
    const Picture found = read("p.hdr");
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 40; ++column) EXPECT_EQ(found.at(column, row)[1], 2.0078125f);
    EXPECT_FALSE(folder.has("p.hdr.partial"));
}

TEST_F(RpictRecovery, keeps_the_picture_whatever_its_name) {
    const std::string rpict = "rpict -x 4 -y 4 ";
    ASSERT_EQ(run(rpict + "room.oct > p.hdr").status, 0);
    const Picture whole = read("p.hdr");
    ASSERT_EQ(run(rpict + "-r ./p.hdr -o p.hdr room.oct && ln -s p.hdr link.hdr && " + rpict +
                  "-r link.hdr -o p.hdr room.oct && " + rpict + "-r p.hdr -o link.hdr room.oct")
                  .status,
              0);
    ASSERT_TRUE(folder.has("p.hdr"));
    EXPECT_TRUE(folder.has("link.hdr"));
    EXPECT_EQ(read("p.hdr").pixels, whole.pixels);
}

TEST_F(RpictRecovery, refuses_rows_of_another_kind_at_once) {
    // Stopped while it finished another's rows of RGB.
    ASSERT_EQ(run("rpict -x 40 -y 30 -ps 1 room.oct > p.hdr").status, 0);
    folder.write("p.hdr", folder.read("p.hdr").substr(0, 1000));
    ASSERT_EQ(stop("rpict -t 1000 -ab 2 -aa 0 -ad 9000 -as 0 -ro p.hdr room.oct", "0").status, 3);
    ASSERT_TRUE(folder.has("p.hdr.partial"));
    EXPECT_NE(complaint("-pXYZ -ro p.hdr room.oct").find("p.hdr.partial: its pixels are of another kind"),
              std::string::npos);
    EXPECT_TRUE(folder.has("p.hdr.partial"));
}

TEST_F(RpictRecovery, of_a_sequence_goes_on_with_the_picture_numbered) {
    folder.write("views", "VIEW= -vp 0 0 0\nVIEW= -vp 1 0 0\nVIEW= -vp 1 0 1\n");
    const std::string rpict = "rpict -S 1 -t 1000 -ab 2 -aa 0 -as 0 -x 40 -y 40 ";
    ASSERT_EQ(run(rpict + "-ad 200 -o whole%d.exr room.oct < views").status, 0);
    ASSERT_EQ(run("head -1 views | " + rpict + "-ad 200 -o p%d.exr room.oct").status, 0);
    ASSERT_EQ(stop(rpict + "-ad 200 -o p%d.exr room.oct < views", "0").status, 3);
    EXPECT_NE(folder.read("log").find("-r 2 goes on from \"p2.exr.partial\""), std::string::npos)
        << folder.read("log");
    EXPECT_FALSE(folder.has("p2.exr"));
    ASSERT_EQ(run(rpict + "-ad 200 -r 2 -o p%d.exr room.oct < views").status, 0);
    for (const char* name : {"1.exr", "2.exr", "3.exr"})
        EXPECT_EQ(read(std::string("p") + name).pixels, read(std::string("whole") + name).pixels) << name;
    EXPECT_FALSE(folder.has("p2.exr.partial"));
}

TEST_F(RpictRecovery, of_nothing_starts_anew) {
    const Outcome result = run("rpict -x 4 -y 4 -ro p.hdr room.oct");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "rpict: warning - new output file \"p.hdr\"\n");
    EXPECT_EQ(read("p.hdr").width, 4);
}

TEST_F(RpictRecovery, refuses_what_is_no_beginning_of_the_picture) {
    folder.write("empty.hdr", "");
    EXPECT_NE(complaint("-ro empty.hdr room.oct").find("recover file is empty"), std::string::npos);
    const std::string scene = folder.read("room.oct");
    EXPECT_NE(complaint("-ro room.oct room.oct").find("unknown picture format"), std::string::npos);
    EXPECT_EQ(folder.read("room.oct"), scene);
    ASSERT_EQ(run("rpict -pXYZ -x 4 -y 4 -o xyz.hdr room.oct").status, 0);
    EXPECT_NE(complaint("-ro xyz.hdr room.oct").find("of another kind"), std::string::npos);
    ASSERT_EQ(stop(work + std::string("-o p.hdr room.oct"), "0").status, 3);
    EXPECT_NE(complaint("-cs 8 -ro p.hdr room.oct").find("-cs, -cw"), std::string::npos);
    EXPECT_NE(complaint("-z p.z -ro p.hdr room.oct").find("begun without -z"), std::string::npos);
    EXPECT_TRUE(folder.has("p.hdr.partial"));
}

}  // namespace
}  // namespace infra
