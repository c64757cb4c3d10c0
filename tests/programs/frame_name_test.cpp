#include "rt/programs/frame_name.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace infra
