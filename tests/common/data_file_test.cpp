#include "common/data/data_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "test_files.h"

namespace infra {
namespace {

double at(const DataTable& table, double x) { return table.value({&x, 1}); }

TEST(DataFile, ReadsNumbersAndCommentsInAnyLayout) {
    const DataTable table = parse_data("# head\n1#one\r\n0 1\t3 # axis\n\n+1 2.E+0#two\n.3e1", "layout.dat");
    EXPECT_EQ(table.dimensions(), 1u);
    EXPECT_TRUE(table.axis(0).even());
    EXPECT_EQ(table.axis(0).size(), 3u);
    for (const double x : {0.0, 0.25, 0.5, 0.8, 1.0}) EXPECT_NEAR(at(table, x), 1 + 2 * x, 1e-6);
}

TEST(DataFile, ReadsPlacesOneByOne) {
    // equal ends announce a list, whatever they are
    for (const char* text : {"1 0 0 3 10 20 40 1 2 3", "1 7 7 3 10 20 40 1 2 3", "1 0 0 3 40 20 10 3 2 1"}) {
        const DataTable table = parse_data(text, "places.dat");
        EXPECT_FALSE(table.axis(0).even());
        EXPECT_NEAR(at(table, 15), 1.5, 1e-12);
        EXPECT_NEAR(at(table, 20), 2, 1e-12);
        EXPECT_NEAR(at(table, 30), 2.5, 1e-12);
    }
    EXPECT_NEAR(at(parse_data("1 10 -10 3  1 2 5", "falling.dat"), -5), 3.5, 1e-12);
}

TEST(DataFile, LaterDimensionsChangeFaster) {
    const DataTable table = parse_data("2  0 1 2  0 2 3   1 2 3   4 5 6", "order.dat");
    const double point[2] = {1, 0.5};
    EXPECT_NEAR(table.value(point), 4.5, 1e-12);
}

TEST(DataFile, NamesAFileItCannotRead) {
    const test::TemporaryFolder folder;
    EXPECT_NE(test::error_of([&] { read_data_file(folder / "none.dat"); }).find("none.dat"),
              std::string::npos);
    EXPECT_NE(test::error_of([&] { read_data_file(folder / ""); }).find("it is a folder"), std::string::npos);
}

struct Malformed {
    const char* file;
    int line;
    const char* says;
};

const Malformed malformed[] = {
    {"axis_cut.dat", 3, "the file ends before the number of places of dimension 2"},
    {"binary.dat", 1, "expected the number of dimensions, found \"?ELF"},
    {"commas.dat", 3, "expected a number, found \"1,2,3\" (numbers are separated by blanks, not commas)"},
    {"count_fraction.dat", 2, "expected the number of places of dimension 1, found \"2.5\""},
    {"count_huge.dat", 3, "a table of 40000 x 40000 values is too large"},
    {"count_one.dat", 2, "the number of places of dimension 1 is 1 (there must be at least 2)"},
    {"empty.dat", 1, "the file ends before the number of dimensions"},
    {"infinite.dat", 3, "expected a number, found \"inf\""},
    {"nan.dat", 4, "expected a number, found \"nan\""},
    {"no_dimensions.dat", 2, "the number of dimensions is 0 (from 1 to 16)"},
    {"only_comments.dat", 1, "the file ends before the number of dimensions"},
    {"places_cut.dat", 3, "the file ends before place 3 of dimension 1"},
    {"places_equal.dat", 2, "place 2 of dimension 1 is out of order after 2 (places must rise or fall)"},
    {"places_turn.dat", 3, "place 2.5 of dimension 2 is out of order after 3"},
    {"too_few.dat", 5, "the file ends before value 6 of 6 (2 x 3)"},
    {"too_large.dat", 3, "value 1e+39 is too large"},
    {"too_many.dat", 5, "more numbers than the 6 values (2 x 3)"},
    {"too_many_dimensions.dat", 1, "the number of dimensions is 17 (from 1 to 16)"},
    {"word.dat", 4, "expected a number, found \"warm\""},
};
const std::filesystem::path malformed_folder = INFRA_SOURCE_DIR "/tests/data/malformed/data";

TEST(MalformedDataFiles, AreRefusedWithTheirLine) {
    for (const Malformed& row : malformed) {
        const std::string path = (malformed_folder / row.file).string();
        const std::string what = test::error_of([&] { read_data_file(path); });
        EXPECT_TRUE(what.starts_with(path + ":" + std::to_string(row.line) + ": ")) << what;
        EXPECT_NE(what.find(row.says), std::string::npos) << what << "\nwanted: " << row.says;
        EXPECT_EQ(what.find('\n'), std::string::npos) << row.file;
    }
}

TEST(MalformedDataFiles, AreAllInTheTable) {
    std::set<std::string> in_table, in_folder;
    for (const Malformed& row : malformed) in_table.insert(row.file);
    for (const auto& entry : std::filesystem::directory_iterator(malformed_folder))
        in_folder.insert(entry.path().filename().string());
    EXPECT_EQ(in_table, in_folder);
}

}  // namespace
}  // namespace infra
