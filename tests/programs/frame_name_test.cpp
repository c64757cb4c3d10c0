#include "rt/programs/frame_name.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "command.h"

namespace infra {
namespace {

TEST(FrameName, has_the_number_where_printf_puts_it) {
    EXPECT_EQ(frame_name("f%d.hdr", 7), "f7.hdr");
    EXPECT_EQ(frame_name("f%03d.hdr", 7), "f007.hdr");
    EXPECT_EQ(frame_name("%d/f%04i.exr", 12), "12/f0012.exr");
    EXPECT_EQ(frame_name("f%%d%d", 1), "f%d1");
}

TEST(FrameName, keeps_whatever_is_no_place_for_a_number) {
    for (const char* name : {"", "plain.hdr", "100%", "50%.hdr", "%s", "%5.2f", "%n", "%99999d", "a%"}) {
        EXPECT_EQ(frame_name(name, 3), name);
        EXPECT_FALSE(has_frame_number(name)) << name;
    }
    EXPECT_TRUE(has_frame_number("f%02d.hdr"));
    EXPECT_FALSE(has_frame_number("f%%d.hdr"));
}

TEST(FrameClaim, is_granted_once_and_leaves_nothing_unless_kept) {
    const test::Folder folder;
    const std::string path = folder.path("f.hdr");
    {
        const FrameClaim mine(path);
        EXPECT_TRUE(mine.granted());
        EXPECT_TRUE(folder.has("f.hdr"));
        EXPECT_FALSE(FrameClaim(path).granted());
        EXPECT_TRUE(folder.has("f.hdr"));  // the other's stays
    }
    EXPECT_FALSE(folder.has("f.hdr"));
    FrameClaim(path).keep();
    EXPECT_TRUE(folder.has("f.hdr"));
    EXPECT_NE(test::error_of([&] { FrameClaim(folder.path("none/f.hdr")); }), "no error");
}

TEST(FrameClaim, of_a_program_that_has_ended_is_taken_over) {
    const test::Folder folder;
    const std::string path = folder.path("f.hdr");
    folder.write("f.hdr", "");
    {
        FrameClaim other(path);
        EXPECT_FALSE(other.granted());
        EXPECT_TRUE(other.take_over());
        EXPECT_TRUE(other.granted());
        // Another process sees that this one lives.
        const pid_t child = fork();
        if (child == 0) _exit(FrameClaim(path).take_over() ? 1 : 0);
        int status = -1;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_FALSE(folder.has("f.hdr"));
    folder.write("f.hdr", "a picture");
    FrameClaim late(path);
    EXPECT_FALSE(late.take_over());
    EXPECT_EQ(folder.read("f.hdr"), "a picture");
}

}  // namespace
}  // namespace infra
