// irview as its users run it: what it prints, writes and refuses.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "common/pictures/picture.h"
#include "pictures.h"

namespace infra::ir {
namespace {

struct Outcome {
    int status = -1;
    std::string text;  ///< standard output and standard error
};

class Irview : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("irview_test_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        write_exr(path("ramp.exr"), ramp(40, 20, 3), {});
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    Outcome run(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder_.string() + "' && '" + INFRA_BIN_DIR + "/irview' " + arguments + " 2>&1";
        std::FILE* pipe = popen(command.c_str(), "r");
        Outcome outcome;
        char buffer[4096];
        for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
            outcome.text.append(buffer, n);
        outcome.status = WEXITSTATUS(pclose(pipe));
        return outcome;
    }

    std::filesystem::path folder_;
};

TEST_F(Irview, PrintsStatisticsOfEveryRegionAndChannel) {
    const Outcome outcome = run("-stats -region 1 0 3 2 box -region 5 5 6 6 dot ramp.exr");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.text,
              "# region\tchannel\tpixels\tmean\tdeviation\tminimum\tmaximum\n"
              "box\t0\t4\t6.5\t5.8022984\t1\t12\n"
              "box\t1\t4\t106.5\t5.8022984\t101\t112\n"
              "box\t2\t4\t206.5\t5.8022984\t201\t212\n"
              "dot\t0\t1\t55\t0\t55\t55\n"
              "dot\t1\t1\t155\t0\t155\t155\n"
              "dot\t2\t1\t255\t0\t255\t255\n");
}

TEST_F(Irview, WritesAPngWithTheLegendBesideThePicture) {
    EXPECT_EQ(run("-s 0 400 -l test -u W.m-2.sr-1 -region 2 2 38 18 all -o out.png ramp.exr").status, 0);
    std::ifstream file(path("out.png"), std::ios::binary);
    std::string start(24, '\0');
    file.read(start.data(), 24);
    EXPECT_EQ(start.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto size = [&start](int at) { return (start[at + 2] & 255) << 8 | (start[at + 3] & 255); };
    EXPECT_GT(size(16), 40);
    EXPECT_GE(size(20), 20);
}

TEST_F(Irview, RefusesInOneLineAndWritesNothing) {
    std::ofstream(path("cut.hdr")) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20 +X 40\n\2\2\0\50\1";
    const std::pair<const char*, const char*> cases[] = {
        {"-o out.png missing.exr", "missing.exr"},
        {"-o out.png cut.hdr", "cut.hdr"},
        {"ramp.exr", "irview: nothing to do"},
        {"-stats", "irview: give one picture"},
        {"-stats ramp.exr ramp.exr", "irview: give one picture"},
        {"-o out.png -s 3 3 ramp.exr", "low must be less than high"},
        {"-o out.png -c 3 ramp.exr", "no channel 3"},
        {"-o out.png -b 21 ramp.exr", "blocks of 21 pixels"},
        {"-o out.png -b 0 ramp.exr", "-b"},
        {"-o out.png -region 0 0 41 2 x ramp.exr", "not within the picture"},
        {"-o out.png -region 0 0 4 x ramp.exr", "-region"},
        {"-o out.png -palette jet ramp.exr", "there is no palette \"jet\" (there are inferno, "},
        {"-o nowhere/out.png ramp.exr", "nowhere/out.png"},
    };
    for (const auto& [arguments, expected] : cases) {
        const Outcome outcome = run(arguments);
        EXPECT_NE(outcome.text.find(expected), std::string::npos) << arguments << "\n" << outcome.text;
        EXPECT_EQ(outcome.text.rfind("irview: ", 0), 0u) << arguments << "\n" << outcome.text;
        EXPECT_EQ(outcome.text.find('\n'), outcome.text.size() - 1) << arguments << "\n" << outcome.text;
        EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << arguments;
        EXPECT_FALSE(std::filesystem::exists(path("out.png"))) << arguments;
    }
}

}  // namespace
}  // namespace infra::ir
