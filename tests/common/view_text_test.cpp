#include <gtest/gtest.h>

#include "common/views/view.h"
#include "common/views/view_options.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

TEST(ViewText, IsRadiancesLine) {
    View view;
    EXPECT_EQ(format_view(view), " -vtv -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 45 -vv 45 -vo 0 -va 0 -vs 0 -vl 0");
    parse_view(
        "-vta -vp 1.23456789 2 -3e-9 -vd 0 3 4 -vu 0 0 2 -vh 180 -vv 90.5 -vo .1 -va 1e6 -vs .25 -vl -1",
        view);
    set_up_view(view);
    EXPECT_EQ(
        format_view(view),
        " -vta -vp 1.234568 2 -3e-09 -vd 0 3 4 -vu 0 0 1 -vh 180 -vv 90.5 -vo 0.1 -va 1e+06 -vs 0.25 -vl -1");
}

TEST(ViewText, ParsingPassesOverOtherOptions) {
    View view;
    EXPECT_EQ(parse_view("rpict -ab 2 -vp 1 2 3 -vf x.vf -vtl -vh 7 scene.oct", view), 3);
    EXPECT_EQ(view.point, Vec3(1, 2, 3));
    EXPECT_EQ(view.type, ViewType::parallel);
    EXPECT_EQ(view.horizontal, 7);
    EXPECT_EQ(parse_view("-vp 1 2 -vtq -vh", view), 0);
    EXPECT_EQ(view.horizontal, 7);
}

TEST(ViewText, KnowsViewLines) {
    for (const char* line :
         {"VIEW= -vtv", "rpict -vp 0 0 0", "/usr/local/bin/rpict -x 4", "rview -vh 3", "rvu -vtv"})
        EXPECT_TRUE(is_view_line(line)) << line;
    for (const char* line : {"", "\tVIEW= -vtv", "SOFTWARE= rpict", "oconv a.rad"})
        EXPECT_FALSE(is_view_line(line)) << line;
}

TEST(ViewText, ViewFilesAddUp) {
    const TemporaryFolder folder;
    write_file(folder / "a.vf", "rvu -vtv -vp 1 1 1 -vd 0 0 -1 -vu 0 1 0\nVIEW= -vp 2 2 2 -vh 30\n");
    View view;
    read_view_file(folder / "a.vf", view);
    EXPECT_EQ(view.point, Vec3(2, 2, 2));
    EXPECT_EQ(view.direction, Vec3(0, 0, -1));
    EXPECT_EQ(view.horizontal, 30);

    write_file(folder / "p.hdr", "#?RADIANCE\nVIEW= -vh 20\n\nVIEW= -vh 10\n");
    read_view_file(folder / "p.hdr", view);
    EXPECT_EQ(view.horizontal, 20);

    write_file(folder / "empty.vf", "nothing here\n");
    EXPECT_EQ(
        error_of([&] { read_view_file(folder / "empty.vf", view); }),
        (folder / "empty.vf") + ": bad view file (it has no line such as \"VIEW= -vp 0 0 0 -vd 0 1 0\")");
    EXPECT_EQ(error_of([&] { read_view_file(folder / "none.vf", view); }),
              "cannot read \"" + (folder / "none.vf") + "\": No such file or directory");
}

// The layout of RADIANCE 6.1's "rpict -defaults", tabs included.
TEST(ViewOptions, DefaultsAreRadiances) {
    View view;
    OptionTable table("rpict");
    add_view_options(table, view);
    const auto rest =
        table.parse({"-vtl", "-vp", "1", "2", "-3", "-vd", "0", "0", "5", "-vo", ".5", "scene.oct"});
    ASSERT_TRUE(rest);
    EXPECT_EQ(*rest, std::vector<std::string>{"scene.oct"});
    EXPECT_EQ(table.defaults(),
              "-vtl\t\t\t\t# view type parallel\n"
              "-vp 1.000000 2.000000 -3.000000\t# view point\n"
              "-vd 0.000000 0.000000 5.000000\t# view direction\n"
              "-vu 0.000000 0.000000 1.000000\t# view up\n"
              "-vh 45.000000\t\t\t# view horizontal size\n"
              "-vv 45.000000\t\t\t# view vertical size\n"
              "-vo 0.500000\t\t\t# view fore clipping plane\n"
              "-va 0.000000\t\t\t# view aft clipping plane\n"
              "-vs 0.000000\t\t\t# view shift\n"
              "-vl 0.000000\t\t\t# view lift\n");
    EXPECT_EQ(error_of([&] { table.parse({"-vtq"}); }),
              "command line error at '-vtq': unknown view type (the types are v l c h a s, as in -vtv)");
}

}  // namespace
}  // namespace infra
