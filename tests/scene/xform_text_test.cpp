// The text that xform writes, against what RADIANCE 6.1 writes of the same scenes (tests/data/xform).
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/format.h"
#include "scene/xform/run.h"

namespace infra::xform {
namespace {

const std::filesystem::path data_folder = INFRA_SOURCE_DIR "/tests/data/xform";

/// The files of the cases are named without a folder.
class InDataFolder {
  public:
    InDataFolder() : before_(std::filesystem::current_path()) { std::filesystem::current_path(data_folder); }
    ~InDataFolder() { std::filesystem::current_path(before_); }

  private:
    std::filesystem::path before_;
};

std::string text_of(const std::vector<std::string>& words) {
    std::FILE* const file = std::tmpfile();
    run(words, file);
    std::rewind(file);
    std::string text;
    for (int c = std::getc(file); c != EOF; c = std::getc(file)) text += static_cast<char>(c);
    std::fclose(file);
    return text;
}

TEST(XformText, IsRadiances) {
    const InDataFolder here;
    std::ifstream cases("cases.txt");
    int count = 0;
    for (std::string line; std::getline(cases, line); ++count) {
        std::vector<std::string> words = split_words(line);
        std::stringstream expected;
        expected << std::ifstream(words[0] + ".expected").rdbuf();
        words[0] = "xform";
        EXPECT_EQ(text_of(words), expected.str()) << line;
    }
    EXPECT_EQ(count, 14);
}

TEST(XformText, QuotesInAListEndWhereTheyAreClosed) {
    const InDataFolder here;
    const auto list = std::filesystem::path(testing::TempDir()) / "quoted.txt";
    std::ofstream(list) << "-n \"a b\" -t 0 0 1\n";
    EXPECT_EQ(text_of({"xform", "-f", list.string(), "inner.rad"}),
              "# xform -n a b.0 -t 0 0 1\n\nwhite polygon \"a b.0.tile\"\n0\n0\n9\n"
              "                  0                  0                  1\n"
              "                  1                  0                  1\n"
              "                  0                  1                  1\n");
}

}  // namespace
}  // namespace infra::xform
