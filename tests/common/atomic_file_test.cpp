#include "common/atomic_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>

#include "common/interrupt.h"
#include "common/text_file.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

TEST(AtomicFile, AppearsOnCommit) {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    AtomicFile file(folder / "a");
    std::fputs("new", file.stream());
    EXPECT_EQ(read_text_file(folder / "a"), "old");
    file.commit();
    EXPECT_EQ(read_text_file(folder / "a"), "new");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, VanishesOtherwise) {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a");
        std::fputs("half", file.stream());
        EXPECT_EQ(folder.file_count(), 1u);
    }
    EXPECT_EQ(folder.file_count(), 0u);
}

TEST(AtomicFile, RefusesWhatCannotBeWritten) {
    const TemporaryFolder folder;
    EXPECT_EQ(error_of([&] { AtomicFile file(folder / "no/a"); }),
              "cannot write \"" + (folder / "no/a") + "\": No such file or directory");
    std::filesystem::create_directory(folder / "d");
    EXPECT_EQ(error_of([&] { AtomicFile file(folder / "d"); }),
              "cannot write \"" + (folder / "d") + "\": it is a folder");
}

TEST(AtomicFile, DevicesAndLinksKeepTheirNames) {
    AtomicFile null("/dev/null");
    std::fputs("gone", null.stream());
    null.commit();
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    if (std::filesystem::exists("/dev/full")) {
        AtomicFile full("/dev/full");
        std::fputs("too much", full.stream());
        EXPECT_EQ(error_of([&] { full.commit(); }), "cannot write \"/dev/full\": No space left on device");
    }
    const TemporaryFolder folder;
    write_file(folder / "target", "old");
    std::filesystem::create_symlink(folder / "target", folder / "link");
    AtomicFile file(folder / "link");
    std::fputs("new", file.stream());
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(read_text_file(folder / "target"), "new");
}

TEST(Interrupt, FirstSignalAsks) {
    EXPECT_FALSE(interrupted());
    {
        const InterruptGuard guard;
        EXPECT_NO_THROW(throw_if_interrupted());
        raise(SIGTERM);
        EXPECT_TRUE(interrupted());
        EXPECT_EQ(error_of([] { throw_if_interrupted(); }), "interrupted");
    }
    EXPECT_FALSE(interrupted());
}

TEST(InterruptDeathTest, SecondSignalRemovesPartialFilesAndEnds) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // OpenImageIO has threads of its own
    const TemporaryFolder folder;
    const std::string path = folder / "a";
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            AtomicFile file(path);
            AtomicFile other(path + "2");
            raise(SIGINT);
            raise(SIGINT);
            _exit(0);
        },
        testing::KilledBySignal(SIGINT), "");
    EXPECT_EQ(folder.file_count(), 0u);
}

TEST(InterruptDeathTest, SignalWithoutAnswerEndsTheProgram) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const TemporaryFolder folder;
    const std::string path = folder / "a";
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            AtomicFile file(path);
            raise(SIGTERM);
            for (;;) pause();
        },
        testing::KilledBySignal(SIGTERM), "");
    EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace infra
