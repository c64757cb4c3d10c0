#include "nrlbrdf/table_set.h"

#include <gtest/gtest.h>

#include <fstream>

#include "common/test_files.h"
#include "nrlbrdf/models.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

LoadedTable table_of(double reflectance, std::optional<WavelengthBand> band,
                     const GridCounts& counts = {3, 4, 3}) {
    return {
        std::make_shared<const BrdfTable>(tabulate(lambertian(reflectance), counts)), band, {"set", 1}, {}};
}

std::string message_of(std::vector<LoadedTable> tables) {
    try {
        order_table_set(tables);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TableSet, IsReadFromJoinedFiles) {
    const test::TemporaryFolder folder;
    const WavelengthBand bands[] = {{8, 9}, {3.7, 4.8}, {9, 12}};
    std::string joined;
    for (int n = 0; n < 3; ++n) {
        const std::string path = folder / "one.brdf";
        BrdfGrid grid = tabulate(lambertian(0.1 * (n + 1)), {3, 4, 5});
        grid.phi_origin = n == 1 ? pi : 0;  // a directive of one table is not one of the next
        write_table(path, grid, "a comment", bands[n]);
        std::ifstream file(path);
        joined.append(std::istreambuf_iterator<char>(file), {});
    }
    std::ofstream(folder / "all.brdf") << "# of three\n" << joined;
    const std::vector<LoadedTable> tables = load_tables(folder / "all.brdf");
    ASSERT_EQ(tables.size(), 3U);
    for (int n = 0; n < 3; ++n) {
        const LoadedTable& one = tables[static_cast<std::size_t>(n)];
        EXPECT_EQ(one.band, bands[n]);
        EXPECT_NEAR(one.table->diffuse_reflectance(), 0.1 * (n + 1), 1e-7);
        EXPECT_EQ(one.table->phi_origin() != 0, n == 1);
    }
    EXPECT_EQ(tables[0].place.line, 3);
    EXPECT_EQ(tables[1].place.line, 3 + 2 + 12 + 2);
    try {
        load_table(folder / "all.brdf");
        ADD_FAILURE() << "took the first of three";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(),
                  (folder / "all.brdf") + ":19: another table of a file that should have one only");
    }
}

TEST(TableSet, IsOrderedFromTheLongestWavelength) {
    std::vector<LoadedTable> tables = {table_of(0.1, WavelengthBand{8, 9}),
                                       table_of(0.2, WavelengthBand{9, 12}),
                                       table_of(0.3, WavelengthBand{3, 5})};
    order_table_set(tables);
    EXPECT_EQ(tables[0].band->lo_um, 9);
    EXPECT_EQ(tables[2].band->lo_um, 3);
}

TEST(TableSet, RefusesTablesThatDoNotFit) {
    const WavelengthBand low{8, 9}, high{9, 10};
    EXPECT_EQ(message_of({table_of(0.1, {})}), "");
    EXPECT_EQ(message_of({table_of(0.1, low), table_of(0.2, high)}), "");
    EXPECT_EQ(
        message_of({table_of(0.1, low), table_of(0.2, {})}),
        "set:1: this table states no band, and it is one of several (#% band lo hi, in um, stands before "
        "each of them)");
    EXPECT_EQ(message_of({table_of(0.1, WavelengthBand{8, 9.5}), table_of(0.2, high)}),
              "set:1: band 8-9.5 um overlaps 9-10 um of set:1");
    EXPECT_EQ(
        message_of({table_of(0.1, low), table_of(0.2, high, {3, 4, 5})}),
        "set:1: the grid, 3 x 4 x 5, is not that of set:1, 3 x 4 x 3 (brdftab -table old.brdf -n 3 4 3 -o "
        "new.brdf makes another grid)");
}

TEST(TableSet, ChannelsTakeWhatTheirBandsHaveInCommon) {
    // Channels of 1 um from 12 um down to 8 um; bands 11-12.5, 9.25-11 and 8.5-9.25.
    const Channels channels = Channels::spectral(4, 8000, 12000);
    std::vector<LoadedTable> tables = {table_of(0.1, WavelengthBand{8.5, 9.25}),
                                       table_of(0.2, WavelengthBand{9.25, 11}),
                                       table_of(0.3, WavelengthBand{11, 12.5})};
    order_table_set(tables);
    const ChannelShares shares = share_tables(channels, tables);
    const std::vector<TableShares> expected = {{1, 0, 0}, {0, 1, 0}, {0, 0.75, 0.25}, {0, 0, 1}};
    ASSERT_EQ(shares.of_channel.size(), 4U);
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t t = 0; t < 3; ++t)
            EXPECT_NEAR(shares.of_channel[c][t], expected[c][t], 1e-9) << c << t;
    EXPECT_TRUE(shares.without_band.empty());
    EXPECT_EQ(shares.only_table(), -1);
    EXPECT_EQ(describe_gaps(channels, shares), "");
}

TEST(TableSet, ChannelsWithoutABandTakeTheNearest) {
    const Channels channels = Channels::spectral(8, 8000, 12000);
    const std::vector<LoadedTable> tables = {table_of(0.3, WavelengthBand{11.5, 12}),
                                             table_of(0.1, WavelengthBand{9, 9.5})};
    const ChannelShares shares = share_tables(channels, tables);
    for (std::size_t c = 0; c < 8; ++c) {
        const double center = channels.center_nm(static_cast<int>(c)) / 1000;
        EXPECT_EQ(shares.of_channel[c], center > 10.5 ? (TableShares{1, 0}) : (TableShares{0, 1})) << center;
    }
    EXPECT_EQ(shares.without_band, (std::vector<int>{1, 2, 3, 4, 6, 7}));
    EXPECT_EQ(describe_gaps(channels, shares),
              "no band for 6 of the 8 channels, between 8 and 11.5 um: they take the nearest one");
}

TEST(TableSet, ASingleTableServesAllChannels) {
    const std::vector<LoadedTable> with = {table_of(0.3, WavelengthBand{8, 9})},
                                   without = {table_of(0.3, {})};
    EXPECT_EQ(share_tables(Channels(), with).only_table(), 0);
    EXPECT_EQ(share_tables(Channels(), without).only_table(), 0);
    const Channels channels = Channels::spectral(4, 8000, 12000);
    EXPECT_EQ(share_tables(channels, with).only_table(), 0);
    EXPECT_EQ(share_tables(channels, with).without_band.size(), 3U);
    EXPECT_EQ(share_tables(channels, without).only_table(), 0);
    EXPECT_TRUE(share_tables(channels, without).without_band.empty());
}

TEST(TableSet, ASecondOneOfManyMayBeAllOfEveryChannel) {
    const std::vector<LoadedTable> tables = {table_of(0.3, WavelengthBand{8, 12}),
                                             table_of(0.1, WavelengthBand{3, 5})};
    EXPECT_EQ(share_tables(Channels::spectral(4, 3000, 5000), tables).only_table(), 1);
    EXPECT_EQ(share_tables(Channels::spectral(4, 8000, 12000), tables).only_table(), 0);
}

}  // namespace
}  // namespace infra
