#include "common/raypath.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "common/text_file.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

/// Sets $RAYPATH and puts the old value back.
class Raypath {
  public:
    explicit Raypath(const std::string& value) {
        if (const char* old = getenv("RAYPATH")) old_ = old;
        setenv("RAYPATH", value.c_str(), 1);
    }
    Raypath(const Raypath&) = delete;
    Raypath& operator=(const Raypath&) = delete;
    ~Raypath() {
        if (old_)
            setenv("RAYPATH", old_->c_str(), 1);
        else
            unsetenv("RAYPATH");
    }

  private:
    std::optional<std::string> old_;
};

TEST(Raypath, SearchesInOrder) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "one/sub");
    std::filesystem::create_directory(folder / "two");
    write_file(folder / "two/a.cal", "2");
    write_file(folder / "two/b.cal", "2");
    write_file(folder / "one/b.cal", "1");
    write_file(folder / "one/sub/c.cal", "1");
    const Raypath raypath((folder / "one") + ":" + (folder / "two") + "/");
    EXPECT_EQ(find_library_file("a.cal"), folder / "two/a.cal");
    EXPECT_EQ(find_library_file("b.cal"), folder / "one/b.cal");
    EXPECT_EQ(find_library_file("sub/c.cal"), folder / "one/sub/c.cal");
    EXPECT_FALSE(find_library_file("none.cal"));
    EXPECT_FALSE(find_library_file(""));
    const std::string error = error_of([] { require_library_file("none.cal", "function file"); });
    EXPECT_EQ(error.find("cannot find function file \"none.cal\" (looked in " + (folder / "one") + ", "), 0u)
        << error;
    EXPECT_NE(error.find("; set RAYPATH to look elsewhere)"), std::string::npos) << error;
}

TEST(Raypath, FullNamesAreTakenAsTheyAre) {
    const TemporaryFolder folder;
    write_file(folder / "a.cal", "1");
    const Raypath raypath((folder / "") + "");
    EXPECT_EQ(find_library_file(folder / "a.cal"), folder / "a.cal");
    EXPECT_FALSE(find_library_file("./a.cal"));
    EXPECT_FALSE(find_library_file("../a.cal"));
    setenv("HOME", (folder / "").c_str(), 1);
    EXPECT_EQ(std::filesystem::path(find_library_file("~/a.cal").value()).filename(), "a.cal");
    EXPECT_FALSE(find_library_file("~nobody-of-that-name/a.cal"));
    EXPECT_EQ(error_of([] { require_library_file("./x.cal", "data file"); }),
              "cannot find data file \"./x.cal\"");
}

TEST(Raypath, ProgramsFindTheirOwnLibrary) {
    const auto folders = library_directories();
    ASSERT_GE(folders.size(), 3u);
    EXPECT_TRUE(folders[folders.size() - 2].ends_with("/../lib"));
    EXPECT_TRUE(folders.back().ends_with("/../share/infradiance"));
}

TEST(TextFile, ErrorsAreClear) {
    const TemporaryFolder folder;
    write_file(folder / "a", std::string("x\0y", 3));
    EXPECT_EQ(read_text_file(folder / "a").size(), 3u);
    EXPECT_EQ(error_of([&] { read_text_file(folder / ""); }),
              "cannot read \"" + (folder / "") + "\": it is a folder");
    EXPECT_EQ(error_of([&] { read_text_file(folder / "b"); }),
              "cannot read \"" + (folder / "b") + "\": No such file or directory");
}

}  // namespace
}  // namespace infra
