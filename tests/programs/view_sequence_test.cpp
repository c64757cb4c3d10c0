#include "rt/programs/view_sequence.h"

#include <gtest/gtest.h>

#include "command.h"

namespace infra {
namespace {

using test::error_of;

/// A sequence of views from a text.
struct Views {
    test::Folder folder;
    std::FILE* file;
    ViewSequence sequence;

    static View start() {
        View view;
        set_up_view(view);
        return view;
    }
    explicit Views(const std::string& text)
        : file((folder.write("in", text), std::fopen(folder.path("in").c_str(), "r"))),
          sequence(file, "in", start()) {}
    ~Views() { std::fclose(file); }
};

TEST(ViewSequence, changes_what_each_line_mentions) {
    Views views("VIEW= -vp 1 2 3 -vd 0 2 0\nrvu -vtl -vh 7\n/usr/bin/rpict -vp 4 5 6 -x 7\n");
    ASSERT_TRUE(views.sequence.next());
    EXPECT_EQ(views.sequence.view().point.z, 3);
    EXPECT_EQ(views.sequence.view().distance, 2);
    EXPECT_EQ(views.sequence.previous().point.z, 0);
    ASSERT_TRUE(views.sequence.next());
    EXPECT_EQ(views.sequence.view().type, ViewType::parallel);
    EXPECT_EQ(views.sequence.view().horizontal, 7);
    EXPECT_EQ(views.sequence.view().point.z, 3);
    EXPECT_EQ(views.sequence.view().distance, 2);
    EXPECT_EQ(views.sequence.previous().type, ViewType::perspective);
    ASSERT_TRUE(views.sequence.next());
    EXPECT_EQ(views.sequence.view().point.x, 4);
    EXPECT_EQ(views.sequence.view().image_width, 7);
    EXPECT_FALSE(views.sequence.next());
}

TEST(ViewSequence, passes_over_what_is_no_view) {
    Views views("\n# remark\nFRAME=3\nSOFTWARE= x\nVIEW= -vp 1 2 3");  // no line end either
    ASSERT_TRUE(views.sequence.next());
    EXPECT_EQ(views.sequence.view().point.x, 1);
    EXPECT_FALSE(views.sequence.next());
}

TEST(ViewSequence, takes_view_files_in_order) {
    Views views("");
    views.folder.write("v.vf", "rvu -vp 9 8 7 -vh 30\n");
    const std::string path = views.folder.path("v.vf");
    Views with_file("VIEW= -vh 10 -vv 11 -vf " + path + " -vp 1 1 1\n");
    ASSERT_TRUE(with_file.sequence.next());
    EXPECT_EQ(with_file.sequence.view().horizontal, 30);
    EXPECT_EQ(with_file.sequence.view().vertical, 11);
    EXPECT_EQ(with_file.sequence.view().point.y, 1);
}

TEST(ViewSequence, tells_the_line_of_what_is_wrong) {
    const auto complaint = [](const std::string& line) {
        Views views("VIEW= -vp 0 0 1\n\n" + line + "\n");
        EXPECT_TRUE(views.sequence.next());
        const std::string text = error_of([&] { views.sequence.next(); });
        EXPECT_TRUE(text.starts_with("in:3: ")) << text;
        return text;
    };
    EXPECT_NE(complaint("VIEW= -vp 1 2").find("bad view option '-vp'"), std::string::npos);
    EXPECT_NE(complaint("VIEW= -vh wide").find("bad view option '-vh'"), std::string::npos);
    EXPECT_NE(complaint("VIEW= -vtx").find("bad view option '-vtx'"), std::string::npos);
    EXPECT_NE(complaint("VIEW= hello").find("no view option"), std::string::npos);
    EXPECT_NE(complaint("VIEW= -vd 0 0 1").find("view up parallel"), std::string::npos);
    EXPECT_NE(complaint("VIEW= -vf").find("-vf without a file"), std::string::npos);
    EXPECT_NE(complaint("VIEW= -vf /none").find("/none"), std::string::npos);
    EXPECT_NE(complaint("-vp 1 2 3").find("start it with VIEW="), std::string::npos);
    EXPECT_NE(complaint(std::string(100000, 'x')).find("does not end"), std::string::npos);
}

}  // namespace
}  // namespace infra
