// rpict under mpirun: the bits of one process, and what is left when a rank dies.
#include <gtest/gtest.h>

#include <algorithm>

#include "../command.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

constexpr const char* room =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 1 6 4 .5\n"
    "lum sphere tiny 0 0 4 -1 6 1 .005\n"
    "void plastic paint 0 0 5 .5 .4 .3 .2 .2\n"
    "paint polygon floor 0 0 12 -9 0 -1  9 0 -1  9 18 -1  -9 18 -1\n"
    "paint sphere ball 0 0 4 0 6 0 1\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n";

constexpr const char* camera = " -aa 0 -as 0 -pa 0 -vh 50 -vv 40 -vp .1 .2 .3 ";

/// Without mpirun, what does not need it.
struct RpictLaunch : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("room.rad", room);
        folder.write("views", "VIEW= -vp 0 0 0\nVIEW= -vp 1 0 0\n");
        ASSERT_EQ(test::run(folder, "oconv -f room.rad > room.oct").status, 0);
    }
    Outcome run(const std::string& command) { return test::run(folder, command); }
};

TEST_F(RpictLaunch, as_one_of_several_without_mpi_is_an_error) {
    // A build without MPI is one without rpict-mpi.
    ASSERT_EQ(run("mkdir bin && cp '" INFRA_BIN_DIR "/rpict' bin").status, 0);
    const Outcome result =
        run("OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=2 bin/rpict -x 4 -y 4 -o p.hdr room.oct");
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.find("rpict: started as one of several ranks, but built without MPI"), 0U)
        << result.err;
    EXPECT_FALSE(folder.has("p.hdr"));
    // One rank makes one picture.
    EXPECT_EQ(
        run("RAYPATH=.:'" INFRA_SOURCE_DIR "/lib' OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=1 bin/rpict "
            "-x 4 -y 4 -o p.hdr room.oct")
            .status,
        0);
    EXPECT_TRUE(folder.has("p.hdr"));
}

#ifdef INFRA_MPIRUN
constexpr const char* mpirun = INFRA_MPIRUN;
#else
constexpr const char* mpirun = "";
#endif

struct RpictMpi : RpictLaunch {
    void SetUp() override {
        if (run(std::string("'") + mpirun + "' --version").status != 0)
            GTEST_SKIP() << "mpirun is missing, or rpict was built without MPI";
        RpictLaunch::SetUp();
    }

    /// MPI itself never frees some of its memory.
    static std::string mpi(int ranks) {
        return "ASAN_OPTIONS=detect_leaks=0 '" + std::string(mpirun) +
               "' --oversubscribe --allow-run-as-root -np " + std::to_string(ranks) + " ";
    }

    /// Runs a command in a folder "r", alone or with ranks, and returns all files that it makes, and its
    /// output.
    std::string files_of(const std::string& launcher, const std::string& command) {
        const Outcome result =
            run("rm -rf r && mkdir r && cd r && " + launcher + command + " && tail -vn +1 *");
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }
    void expect_same(const std::string& command, int most_ranks = 2) {
        const std::string alone = files_of("", command);
        EXPECT_NE(alone.find("VIEW="), std::string::npos) << command;
        for (int ranks = 1; ranks <= most_ranks; ++ranks)
            EXPECT_TRUE(files_of(mpi(ranks), command) == alone) << ranks << " ranks: " << command;
    }
    static int count(const std::string& text, const std::string& part) {
        int times = 0;
        for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++times;
        return times;
    }
};

TEST_F(RpictMpi, makes_the_same_picture) {
    const std::string rpict = std::string("rpict -ab 1 -ad 16 -x 40 -y 30") + camera;
    expect_same(rpict + "-o p.exr -z p.z ../room.oct", 3);
    expect_same(rpict + "-ps 1 -o p.hdr ../room.oct");
    expect_same(rpict + "-spp 4 -se e.exr -split s.exr -o p.exr -z p.z ../room.oct");
    expect_same(rpict + "-pd .5 -cs 5 -o p.hsr ../room.oct");
    expect_same(rpict + "< ../room.oct > p.hdr");
}

TEST_F(RpictMpi, makes_the_same_sequence) {
    const std::string rpict = std::string("rpict -ab 1 -ad 16 -x 40 -y 30 -S 1 -pm .5") + camera;
    expect_same(rpict + "-o p%d.exr -z z%d ../room.oct < ../views");
    expect_same(rpict + "../room.oct < ../views > p");
}

TEST_F(RpictMpi, says_things_once) {
    const Outcome report = run(mpi(2) + "rpict -t 100 -ps 99 -x 4 -y 4 room.oct > p.hdr");
    EXPECT_EQ(report.status, 0);
    EXPECT_EQ(count(report.err, "pixel sampling reduced"), 1) << report.err;
    EXPECT_EQ(count(report.err, "100.00% after"), 1) << report.err;
    const Outcome missing = run(mpi(2) + "rpict none.oct > p.hdr");
    EXPECT_NE(missing.status, 0);
    EXPECT_EQ(count(missing.err, "none.oct"), 1) << missing.err;
    EXPECT_EQ(count(run(mpi(2) + "rpict -defaults").out, "ambient bounces"), 1);
}

TEST_F(RpictMpi, names_the_rank_that_cannot_work) {
    ASSERT_EQ(run("mkdir empty").status, 0);
    const Outcome result = run(mpi(2) +
                               "sh -c '[ $OMPI_COMM_WORLD_RANK = 0 ] || cd empty; exec rpict -o p.hdr "
                               "room.oct'");
    EXPECT_NE(result.status, 0);
    EXPECT_EQ(count(result.err, "rpict: "), 1) << result.err;
    EXPECT_NE(result.err.find("rpict: rank 1 on "), std::string::npos) << result.err;
    EXPECT_FALSE(folder.has("p.hdr"));
}

TEST_F(RpictMpi, refuses_persistence) {
    const Outcome result = run(mpi(2) + "rpict -PP file -S 1 -o p%d.hdr room.oct < views");
    EXPECT_NE(result.status, 0);
    EXPECT_EQ(count(result.err, "rpict: -P and -PP are not for several ranks"), 1) << result.err;
    EXPECT_FALSE(folder.has("file"));
}

/// Pictures of some seconds' work that a rank does not live to see.
struct RpictMpiKilled : RpictMpi {
    static constexpr int width = 120, height = 80;
    const std::string rpict = "rpict -t 1000 -ck .05 -ab 1 -ad 2000 -x 120 -y 80" + std::string(camera);

    /// Runs a command with two ranks, and kills one of them as soon as some pixels are in the file.
    void kill_rank(int rank, const std::string& command, const std::string& partial) {
        // A file of no pixels has a byte for each, and a header.
        const std::string enough = std::to_string(width * height + 4000);
        const Outcome result =
            run("rm -f pid*; " + mpi(2) + "sh -c 'echo $$ > pid$OMPI_COMM_WORLD_RANK; exec \"$@\"' x " +
                command + " & job=$!; until [ $(stat -c %s " + partial + " 2> /dev/null || echo 0) -gt " +
                enough + " ] || ! kill -0 $job 2> /dev/null; do sleep .01; done; kill -9 $(cat pid" +
                std::to_string(rank) + "); wait $job");
        EXPECT_NE(result.status, 0) << "it ended before a rank could be killed";
        ASSERT_TRUE(folder.has(partial)) << result.err;
    }
    /// The number of rays in the last report.
    static std::string rays(const Outcome& result) {
        const std::size_t end = result.err.rfind(" rays, 100.00%");
        if (end == std::string::npos) return "no report: " + result.err;
        const std::size_t start = result.err.rfind(' ', end - 1) + 1;
        return result.err.substr(start, end - start);
    }
};

TEST_F(RpictMpiKilled, leaves_what_the_same_command_goes_on_with) {
    const std::string command = rpict + "-o p.exr -z p.z room.oct";
    const std::string all_rays = rays(run(command));
    const std::string picture = folder.read("p.exr"), depth = folder.read("p.z");
    for (const int killed : {1, 0}) {
        ASSERT_EQ(run("rm p.exr p.z").status, 0);
        kill_rank(killed, command, "p.exr.partial");
        EXPECT_FALSE(folder.has("p.exr"));
        // How much one process has left to do that knows what is in the file.
        ASSERT_EQ(run("cp p.exr.partial q.exr.partial").status, 0);
        const std::string rest = rays(run(rpict + "-ro q.exr -z q.z room.oct"));
        EXPECT_LT(std::stoll(rest), std::stoll(all_rays));
        const Outcome again = run(mpi(3) + command);
        EXPECT_EQ(again.status, 0) << again.err;
        EXPECT_EQ(rays(again), rest);  // nothing in it was traced again
        EXPECT_TRUE(folder.read("p.exr") == picture);
        EXPECT_TRUE(folder.read("p.z") == depth);
        EXPECT_FALSE(folder.has("p.exr.partial"));
    }
}

TEST_F(RpictMpiKilled, does_not_go_on_with_what_another_command_left) {
    kill_rank(1, rpict + "-o p.exr room.oct", "p.exr.partial");
    const std::string left = folder.read("p.exr.partial");
    const Outcome other = run(mpi(2) + rpict + "-ps 3 -o p.exr room.oct");
    EXPECT_NE(other.status, 0);
    EXPECT_EQ(count(other.err, "p.exr.partial: it is an unfinished picture of another command"), 1)
        << other.err;
    folder.write("room.rad", std::string(room) + "paint sphere another 0 0 4 1 6 0 .5\n");
    ASSERT_EQ(run("oconv -f room.rad > room.oct").status, 0);
    EXPECT_NE(run(mpi(2) + rpict + "-o p.exr room.oct").status, 0);
    EXPECT_TRUE(folder.read("p.exr.partial") == left);
    EXPECT_FALSE(folder.has("p.exr"));
}

TEST_F(RpictMpiKilled, in_a_sequence_goes_on_with_the_picture_it_was_at) {
    const std::string command = rpict + "-e log -S 1 -o p%d.exr room.oct < views";
    ASSERT_EQ(run(command).status, 0);
    const std::string first = folder.read("p1.exr"), second = folder.read("p2.exr");
    ASSERT_EQ(run("rm p2.exr").status, 0);
    kill_rank(0, command, "p2.exr.partial");
    EXPECT_EQ(folder.read("p2.exr"), "");  // says that the picture is taken
    const Outcome again = run("touch before; sleep .01; " + mpi(2) + command + " && ! [ p1.exr -nt before ]");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_TRUE(folder.read("p1.exr") == first);
    EXPECT_TRUE(folder.read("p2.exr") == second);
    EXPECT_FALSE(folder.has("p2.exr.partial"));
}

}  // namespace
}  // namespace infra
