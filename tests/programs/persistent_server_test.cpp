// -P and -PP: several commands, one loaded scene.
#include <gtest/gtest.h>

#include <algorithm>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

struct Persistent : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("sky.rad", "void glow g 0 0 4 .5 .5 .5 0\ng source sky 0 0 4 0 0 1 360\n");
        ASSERT_EQ(test::run(folder, "oconv sky.rad > sky.oct").status, 0);
        folder.write("ray", "0 0 0 0 1 0\n");
        folder.write("views", "VIEW= -vp 0 0 0\n");
    }
    Outcome run(const std::string& command) { return test::run(folder, command); }
    /// Ends the server and waits until it is gone.
    void end(const std::string& file, const std::string& signal = "HUP") {
        EXPECT_EQ(run("kill -" + signal + " $(awk '{print $2; exit}' " + file +
                      "); for i in $(seq 250); do test -e " + file + " || exit 0; sleep .02; done; exit 1")
                      .status,
                  0);
        EXPECT_FALSE(folder.has(file));
    }
};

constexpr const char* value = "5.000000e-01\t5.000000e-01\t5.000000e-01\t\n";

TEST_F(Persistent, commands_are_served_without_the_scene) {
    for (const char* option : {"-P", "-PP"}) {
        const std::string rtrace = std::string("rtrace -h- ") + option + " p ";
        EXPECT_EQ(run(rtrace + "sky.oct < ray").out, value);
        EXPECT_TRUE(folder.read("p").starts_with("rtrace "));
        for (int i = 0; i < 3; ++i) {
            const Outcome served = run(rtrace + "< ray");
            EXPECT_EQ(served.out, value);
            EXPECT_EQ(served.err, "");
            EXPECT_EQ(served.status, 0);
        }
        end("p");
    }
}

TEST_F(Persistent, commands_are_served_at_once) {
    // Both are open at the same time, and a third one comes and goes.
    ASSERT_EQ(run("rtrace -h- -PP p sky.oct < ray").out, value);
    const Outcome result =
        run("mkfifo a b; rtrace -PP p < a > ra & rtrace -PP p < b > rb & exec 3> a 4> b; rtrace -PP p < ray; "
            "cat ray >&4; cat ray >&3; exec 3>&- 4>&-; wait; cat ra rb");
    EXPECT_EQ(result.out, std::string(value) + value + value);
    end("p", "TERM");
}

TEST_F(Persistent, pictures_are_served) {
    ASSERT_EQ(run("rpict -S 1 -PP p -x 8 -y 8 sky.oct < views > a.hdr").status, 0);
    const Outcome served = run("rpict -PP p < views > b.hdr");
    EXPECT_EQ(served.status, 0) << served.err;
    EXPECT_EQ(folder.read("a.hdr"), folder.read("b.hdr"));
    folder.write("bad", "VIEW= -vp x\n");
    const Outcome failed = run("rpict -PP p < bad");
    EXPECT_EQ(failed.status, 1);  // the command's own messages and status
    EXPECT_NE(failed.err.find("standard input:1: bad view option"), std::string::npos) << failed.err;
    EXPECT_NE(run("rtrace -PP p sky.oct < ray").err.find("persist file for rpict, not rtrace"),
              std::string::npos);
    end("p");
}

TEST_F(Persistent, commands_started_together_load_the_scene_once) {
    const Outcome result =
        run("for i in 1 2 3 4; do rtrace -h- -PP p sky.oct < ray & done; wait; grep -c '^rtrace ' p");
    EXPECT_EQ(result.out, std::string(value) + value + value + value + "1\n");
    EXPECT_EQ(result.err, "rtrace: warning - no light sources found\n");  // said by whoever loads it
    end("p", "TERM");  // a shell's background commands ignore INT
}

TEST_F(Persistent, a_command_that_is_killed_takes_its_work_along) {
    ASSERT_EQ(run("rtrace -h- -P p sky.oct < ray").out, value);
    const Outcome result = run(
        "workers_become() { for i in $(seq 500); do test $(ps -o pid= --ppid $server | wc -l) = $1 && "
        "echo $1 && return; sleep .02; done; echo never; }; "
        "mkfifo a; rtrace -PP p < a > /dev/null & exec 3> a; server=$(awk '{print $2; exit}' p); "
        "workers_become 1; kill $!; workers_become 0");
    EXPECT_EQ(result.out, "1\n0\n") << result.err;
    end("p");
}

TEST_F(Persistent, a_dead_servers_file_is_taken_over) {
    ASSERT_EQ(run("rtrace -h- -PP p sky.oct < ray").out, value);
    ASSERT_EQ(run("kill -KILL $(awk '{print $2; exit}' p); sleep .1").status, 0);
    EXPECT_EQ(run("rtrace -h- -PP p sky.oct < ray").out, value);
    EXPECT_EQ(run("rtrace -PP p < ray").out, value);
    end("p");
}

TEST_F(Persistent, commands_without_streams_are_served) {
    for (int i = 0; i < 2; ++i) {  // the one that leaves a server, and one that it serves
        const Outcome result = run("timeout 20 rtrace -h- -w -PP p sky.oct <&-");
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.status, 0) << result.err;
    }
    EXPECT_EQ(run("rtrace -h- -PP p < ray").out, value);
    end("p", "TERM");
}

TEST_F(Persistent, nobody_waits_for_the_server) {
    const Outcome result =
        run("rtrace -h- -w -PP p sky.oct < ray 7> held | cat; ls -l /proc/"
            "$(awk '{print $2; exit}' p)/fd | grep -c -e held -e pipe:");
    EXPECT_EQ(result.out, std::string(value) + "0\n");
    EXPECT_EQ(run("rtrace -h- -PP p < ray").out, value);
    end("p", "TERM");
}

TEST_F(Persistent, no_folder_is_left_when_there_can_be_no_server) {
    const std::string deep = std::string(60, 'a') + "/" + std::string(60, 'b');
    const Outcome named =
        run("mkdir -p " + deep + "; TMPDIR=$PWD/" + deep + " rtrace -w -PP p sky.oct < ray; ls -A " + deep);
    EXPECT_NE(named.err.find("is too long"), std::string::npos) << named.err;
    EXPECT_EQ(named.out, "");
    const Outcome full =
        run("mkdir t; (trap '' XFSZ; ulimit -f 0; TMPDIR=$PWD/t rtrace -w -PP p sky.oct < ray "
            "2>&1) | cat; ls -A t");
    EXPECT_TRUE(full.out.starts_with("rtrace: cannot write persist file")) << full.out;
    EXPECT_EQ(std::count(full.out.begin(), full.out.end(), '\n'), 1) << full.out;
    EXPECT_FALSE(folder.has("p"));
}

TEST_F(Persistent, signals_that_were_ignored_stay_so) {
    ASSERT_EQ(run("trap '' HUP; rtrace -h- -PP p sky.oct < ray").out, value);
    EXPECT_EQ(run("kill -HUP $(awk '{print $2; exit}' p); sleep .2; rtrace -h- -PP p < ray").out, value);
    end("p", "TERM");
}

TEST_F(Persistent, refuses_what_cannot_be) {
    const auto complaint = [&](const std::string& command) {
        const Outcome result = run(command);
        EXPECT_NE(result.status, 0);
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        return result.err;
    };
    EXPECT_NE(complaint("rpict -PP p sky.oct").find("persist option only for sequences"), std::string::npos);
    EXPECT_NE(
        complaint("rpict -S 1 -PP p -r x sky.oct < views").find("persist option used with recover file"),
        std::string::npos);
    EXPECT_NE(complaint("rtrace -PP p none.oct < ray").find("none.oct"), std::string::npos);
    EXPECT_FALSE(folder.has("p"));
    EXPECT_NE(complaint("rtrace -PP none/p sky.oct < ray").find("cannot open persist file"),
              std::string::npos);
    folder.write("q", "a letter\n");
    EXPECT_NE(complaint("rtrace -PP q sky.oct < ray").find("format error in persist file"),
              std::string::npos);
    EXPECT_EQ(folder.read("q"), "a letter\n");
}

}  // namespace
}  // namespace infra
