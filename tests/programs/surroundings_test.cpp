// What the programs do where files and devices fail them: one line that says so, and a failing status.
#include <gtest/gtest.h>

#include <algorithm>

#include "command.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

struct Surroundings : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("scene.rad",
                     "void light paint 0 0 3 1 1 1\n"
                     "paint sphere ball 0 0 4 0 4 0 1\n");
        ASSERT_EQ(test::run(folder,
                            "oconv scene.rad > scene.oct && "
                            "rpict -x 8 -y 8 scene.oct > picture.hdr && mkdir folder")
                      .status,
                  0);
    }
    void expect_failure(const std::string& command, int status, const std::string& what) const {
        const Outcome result = test::run(folder, command);
        EXPECT_EQ(result.status, status) << command << "\n" << result.err;
        EXPECT_NE(result.err.find(what), std::string::npos) << command << "\n" << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << command << "\n" << result.err;
    }
};

TEST_F(Surroundings, lost_output_is_an_error) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const int system_error = 2;
    for (const char* command :
         {"oconv scene.rad > /dev/full", "xform scene.rad > /dev/full", "getinfo scene.oct > /dev/full",
          "getinfo -d scene.oct > /dev/full", "getinfo -a X=1 < scene.oct > /dev/full",
          "rcalc -n -e '$1=1' > /dev/full", "rpict -defaults > /dev/full",
          "rpict -x 8 -y 8 scene.oct > /dev/full", "rpict -x 8 -y 8 -o /dev/full scene.oct",
          "echo 0 0 0 0 1 0 | rtrace scene.oct > /dev/full", "irview -stats picture.hdr > /dev/full",
          "irview -o /dev/full picture.hdr"})
        expect_failure(command, system_error, "cannot write");
}

TEST_F(Surroundings, lost_pictures_are_named) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    expect_failure("rpict -x 8 -y 8 -o /dev/full scene.oct", 2, "rpict: /dev/full: cannot write");
}

TEST_F(Surroundings, other_pictures_are_not_promised) {
    for (const char* name : {"s.png", "s.PNG", "s.tiff"}) {
        expect_failure(std::string("rpict -x 8 -y 8 -o ") + name + " scene.oct", 1,
                       name + std::string(": rpict writes .hdr, .hsr and .exr (irview makes PNG of them)"));
        EXPECT_FALSE(folder.has(name));
    }
}

TEST_F(Surroundings, what_is_no_picture_is_called_so) {
    folder.write("empty", "");
    folder.write("junk.png", "\x01\x02\xff");
    for (const std::string name : {"empty", "junk.png"})
        expect_failure("irview -stats " + name, 1,
                       name + ": cannot read picture: it is not a picture, or damaged");
    expect_failure("irview -stats folder", 1, "irview: cannot open picture \"folder\": it is a folder");
}

TEST_F(Surroundings, getinfo_reads_openexr) {
    ASSERT_EQ(test::run(folder,
                        "rpict -x 8 -y 4 -pa 0 -o p.exr scene.oct && rpict -cs 3 -cw 8000 9500 -x 8 -y 8 -o "
                        "s.exr scene.oct")
                  .status,
              0);
    const Outcome colors = test::run(folder, "getinfo p.exr");
    EXPECT_EQ(colors.status, 0) << colors.err;
    EXPECT_TRUE(colors.out.starts_with("p.exr:\n\toconv scene.rad\n\trpict -x 8")) << colors.out;
    for (const char* line :
         {"\n\tquantity=radiance\n", "\n\tunit=W.m-2.sr-1\n", "\n\tchannels= B G R\n", "\n\tsoftware="})
        EXPECT_NE(colors.out.find(line), std::string::npos) << line << colors.out;
    EXPECT_NE(test::run(folder, "getinfo s.exr").out.find("S0.8250,000nm"), std::string::npos);
    EXPECT_EQ(test::run(folder, "getinfo -d p.exr").out, "p.exr: -Y 4 +X 8\n");
    folder.write("cut.exr", folder.read("p.exr").substr(0, 100));
    expect_failure("getinfo cut.exr", 1, "getinfo: cut.exr: cannot read picture");
}

TEST_F(Surroundings, a_folder_is_no_file) {
    for (const char* command : {"oconv folder", "oconv -i folder", "xform folder", "rpict folder",
                                "rtrace folder", "rcalc -f folder", "irview -stats folder"})
        expect_failure(command, 1, "folder");
    expect_failure("rpict folder", 1, "folder: cannot be read: Is a directory");
}

TEST_F(Surroundings, strange_file_names_keep_errors_to_one_line) {
    for (const char* command :
         {"oconv '", "xform '", "getinfo '", "rpict '", "rtrace '", "rcalc -f '", "irview -stats '"})
        expect_failure(command + std::string("no\nfile'"), 1, "no?file");
    folder.write("odd\nname.rad", "# nothing\n");
    EXPECT_EQ(test::run(folder, "oconv 'odd\nname.rad' > odd.oct").err,
              "oconv: warning - odd?name.rad: empty file\n");
}

/// One pixel of this takes hours.
TEST_F(Surroundings, a_signal_ends_even_a_long_pixel) {
    folder.write("room.rad",
                 "void plastic paint 0 0 5 .9 .9 .9 0 0\n"
                 "paint bubble room 0 0 4 0 0 0 9\n");
    ASSERT_EQ(test::run(folder, "oconv room.rad > room.oct").status, 0);
    const Outcome ended = test::run(folder,
                                    "rpict -w -x 1 -y 1 -ab 50 -aa 0 -ad 100000000 -lw 0 -o p.hdr room.oct & "
                                    "sleep .5; kill $!; wait $!");
    EXPECT_EQ(ended.status, 128 + 15) << ended.err;
    EXPECT_FALSE(folder.has("p.hdr"));
    EXPECT_FALSE(folder.has("p.hdr.part"));
}

}  // namespace
}  // namespace infra
