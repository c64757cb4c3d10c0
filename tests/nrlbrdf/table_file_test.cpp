#include "nrlbrdf/table_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "common/error.h"
#include "common/test_files.h"
#include "nrlbrdf/models.h"
#include "nrlbrdf/table_set.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

/// A name in a fresh temporary folder; both are gone afterwards.
class TemporaryFile {
  public:
    std::string folder() const { return folder_ / ""; }
    std::string path() const { return folder_ / "table.brdf"; }
    void write(const std::string& text) const {
        std::FILE* file = std::fopen(path().c_str(), "w");
        std::fputs(text.c_str(), file);
        std::fclose(file);
    }

  private:
    test::TemporaryFolder folder_;
};

struct Malformed {
    const char* file;
    int line;
    const char* says;
};
constexpr Malformed malformed[] = {
    {"empty", 1, "table ends before the count Ni"},
    {"only_comments", 1, "table ends before the count Ni"},
    {"two_counts", 2, "table ends before the count Nt"},
    {"count_one", 1, "bad count Np (phi): 1 (a whole number >= 2)"},
    {"count_negative", 1, "bad count Np (phi): -2"},
    {"count_fraction", 1, "bad count Np (phi): 2.5"},
    {"count_nan", 1, "bad count Ni (theta_i): nan"},
    {"count_absurd", 1, "table of 1e+12 values is too large"},
    {"count_overflow", 1, "bad count Nt (theta_r): 1e+300"},
    {"no_values", 1, "found 0 numbers after the counts, not the 13 of 2 x 2 x 3 values"},
    {"truncated", 6, "the table ends in the block theta_i = 90 deg"},
    {"no_diffuse", 5, "found 12 numbers after the counts, not the 13"},
    {"one_too_many", 7, "found 15 numbers after the counts, not the 13"},
    {"far_too_many", 14, "nor 14 with a D before each block"},
    {"negative_value", 6, "negative BRDF value -0.5 at theta_i = 90 deg, phi = 180 deg, theta_r = 45 deg"},
    {"nan_value", 4, "not finite: nan at theta_i = 0 deg, phi = 180 deg, theta_r = 45 deg"},
    {"infinite_value", 3, "not finite: inf at theta_i = 0 deg, phi = 0 deg, theta_r = 90 deg"},
    {"huge_value", 6, "not finite: 1e+99 at theta_i = 90 deg, phi = 180 deg, theta_r = 90 deg"},
    {"overflowing_value", 6, "not finite: inf at theta_i = 90 deg, phi = 180 deg, theta_r = 0 deg"},
    {"negative_diffuse", 2, "diffuse reflectance D is -0.1"},
    {"nan_diffuse", 2, "diffuse reflectance D is nan"},
    {"diffuse_too_large", 2,
     "D = 0.5 is larger than the data allow, 0.314159 at theta_i = 90 deg, phi = 180 deg"},
    {"block_diffuse_too_large", 5,
     "D = 0.9 of the block theta_i = 90 deg is larger than the data allow, 0.628319"},
    {"word_among_values", 4, "expected a number, found \"one\""},
    {"commas", 1, "numbers are separated by blanks, not commas"},
    {"glued_number", 4, "expected a number, found \"0.1.2\""},
    {"hexadecimal", 4, "expected a number, found \"0x10\""},
    {"binary", 1, "expected a number, found \"?ELF"},
    {"unknown_directive", 1, "unknown directive \"phy\" (did you mean phi?)"},
    {"strange_directive", 1, "known are phi 180, mirror 0 and band lo hi"},
    {"directive_value", 1, "bad value \"90\" of directive \"phi\" (180 or 360)"},
    {"mirror_value", 1, "bad value \"90\" of directive \"mirror\" (0 or 180)"},
    {"directive_without_value", 1, "bad value \"\" of directive \"mirror\""},
    {"late_directive", 2, "directive \"phi\" after the first number"},
    {"band_reversed", 1, "band 9 to 8 um is reversed (the shorter wavelength stands first)"},
    {"band_without_width", 1, "band of 8 um has no width"},
    {"band_with_units", 1, "bad band \"8um\" \"9um\" (two wavelengths in um, as in #% band 8 9)"},
    {"band_one_number", 1, "bad band \"8\" \"\""},
    {"band_negative", 1, "bad band \"-8\" \"9\""},
    {"band_infinite", 1, "bad band \"8\" \"inf\""},
    {"band_three_numbers", 1, "bad band \"8\" \"9\""},
    {"band_twice", 2, "two bands for one table (a table follows each #% band)"},
    {"band_without_table", 5, "table ends before the count Ni"},
    {"band_too_early", 3, "found 5 numbers after the counts, not the 9"},
    {"second_table_negative", 9, "negative BRDF value -1 at theta_i = 90 deg, phi = 180 deg"},
    {"bands_mixed", 1, "this table states no band, and it is one of several"},
    {"bands_overlap", 1, "band 8-9 um overlaps 8.5-10 um of "},
    {"bands_of_two_grids", 5, "the grid, 2 x 2 x 3, is not that of "},
    {"mirror_before_band", 5, "put it before the counts, after the table's #% band"},
};

TEST(TableFile, SaysWhatIsWrongAndWhere) {
    for (const Malformed& m : malformed) {
        const std::string path =
            std::string(INFRA_SOURCE_DIR "/tests/data/malformed/brdf/") + m.file + ".brdf";
        try {
            std::vector<LoadedTable> tables = load_tables(path);
            order_table_set(tables);
            ADD_FAILURE() << m.file << " was accepted";
        } catch (const Error& error) {
            const std::string what = error.what();
            EXPECT_EQ(what.find(path + ":" + std::to_string(m.line) + ": "), 0U) << m.file << ": " << what;
            EXPECT_NE(what.find(m.says), what.npos) << m.file << ": " << what;
            EXPECT_EQ(what.find('\n'), what.npos) << m.file;
        }
    }
}

TEST(TableFile, NamesAFileItCannotRead) {
    const TemporaryFile file;
    for (const std::string& path : {file.path(), file.folder()}) {
        try {
            load_table(path);
            ADD_FAILURE() << path << " was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("cannot read \"" + path + "\": "), 0U) << error.what();
        }
    }
}

constexpr const char* rows = "1 2 3\n4 5 6\n";

TEST(TableFile, TakesOneDiffuseOrOnePerBlock) {
    const BrdfGrid once = parse_table(std::string("2 2 3  3.14159265") + " " + rows + rows, "once");
    const BrdfGrid each = parse_table(std::string("2 2 3  3.14 ") + rows + "0 " + rows, "each");
    EXPECT_EQ(once.values, each.values);
    EXPECT_EQ(once.values, (std::vector<float>{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6}));
    EXPECT_NEAR(BrdfTable(each).diffuse_reflectance(), pi, 1e-12);
}

TEST(TableFile, ReadsNumbersAndCommentsInAnyLayout) {
    const BrdfGrid grid = parse_table(
        "# head\n#%phi 360\n2 # Ni\r\n2\t3#Nt\n\n+0 1e0 2.E+0 .3e1 4# four\n5. 6 1 2 3 4 5 00006#end",
        "layout");
    EXPECT_EQ(grid.values, (std::vector<float>{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6}));
    // Too small for a double is zero, not an error.
    EXPECT_EQ(parse_table("2 2 2 0 1e-9999 1 1 1 1 1 1 1", "tiny").values[0], 0);
}

TEST(TableFile, MirrorsHalfATable) {
    const BrdfGrid grid = parse_table("#% phi 180\n2 3 2 0  1 2  3 4  5 6   1 2  3 4  5 6", "half");
    EXPECT_EQ(grid.phi_count, 4);
    EXPECT_EQ(grid.values, (std::vector<float>{1, 2, 3, 4, 5, 6, 3, 4, 1, 2, 3, 4, 5, 6, 3, 4}));
    EXPECT_EQ(grid.phi_origin, 0);
    EXPECT_NEAR(parse_table("#% mirror 0\n2 2 2 0 1 1 1 1 1 1 1 1", "zero").phi_origin, pi, 1e-15);
}

TEST(TableFile, WarnsOfReflectanceOverOneWithTheFigure) {
    const TemporaryFile file;
    file.write(std::string("# too bright\n2 2 3\n0\n") +
               "0.3 0.3 0.3\n0.3 0.3 0.3\n0.6 0.6 0.6\n0.6 0.6 0.6\n");
    const LoadedTable loaded = load_table(file.path());
    ASSERT_EQ(loaded.warnings.size(), 2U);
    // The whole block at 90 deg is 0.6, so that it reflects 0.6 pi; a viewer sees between 0.3 pi and 0.6 pi.
    EXPECT_EQ(loaded.warnings[0], file.path() +
                                      ":6: directional-hemispherical reflectance 1.88496 is over 1 at "
                                      "theta_i = 90 deg");
    EXPECT_EQ(loaded.warnings[1].find(file.path() + ":2: directional-hemispherical reflectance 1.4137"), 0U)
        << loaded.warnings[1];
    file.write(
        "2 2 2 1 0.31830989 0.31830989 0.31830989 0.31830989 0.31830989 0.31830989 0.31830989 0.31830989");
    EXPECT_TRUE(load_table(file.path()).warnings.empty());
}

TEST(TableFile, WritesWhatItReads) {
    const TemporaryFile file;
    for (const double origin : {0.0, pi}) {
        BrdfGrid grid = tabulate(gaussian_lobe(0.2, 0.5, 0.25), {5, 7, 6});
        grid.phi_origin = origin;
        write_table(file.path(), grid, "two lines\nof comment");
        const BrdfGrid again = read_table_file(file.path());
        EXPECT_EQ(again.values, grid.values);
        EXPECT_EQ(again.phi_origin, origin);
    }
    EXPECT_THROW(write_table(file.folder() + "/no/such/folder.brdf", tabulate(lambertian(0.5)), ""), Error);
    EXPECT_THROW(write_table("/dev/full", tabulate(lambertian(0.5)), ""), Error);
}

}  // namespace
}  // namespace infra
