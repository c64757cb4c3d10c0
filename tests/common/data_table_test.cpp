#include "common/data/data_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "common/data/data_file.h"

namespace infra {
namespace {

// Product of a line in each coordinate: what multilinear interpolation gives back exactly.
double multilinear(std::span<const double> point) {
    double product = 1;
    for (std::size_t i = 0; i < point.size(); ++i)
        product *= 1 + 0.25 * static_cast<double>(i + 1) + 0.5 * point[i];
    return product;
}

/// Its values on a grid with even, uneven and falling axes in turn.
DataTable multilinear_table(std::size_t dimensions) {
    std::vector<DataAxis> axes;
    std::vector<std::vector<double>> places;
    for (std::size_t i = 0; i < dimensions; ++i) {
        if (i % 3 == 0) places.push_back({0, 0.5, 1, 1.5, 2});
        if (i % 3 == 1) places.push_back({-1, 0, 2});
        if (i % 3 == 2) places.push_back({3, 1, 0.5, 0});
        axes.push_back(i % 3 == 0 ? DataAxis(0, 2, 5) : DataAxis(places.back()));
    }
    std::vector<float> values;
    std::vector<std::size_t> at(dimensions);
    std::vector<double> point(dimensions);
    for (;;) {
        for (std::size_t i = 0; i < dimensions; ++i) point[i] = places[i][at[i]];
        values.push_back(static_cast<float>(multilinear(point)));
        std::size_t i = dimensions;
        while (i > 0 && ++at[i - 1] == places[i - 1].size()) at[--i] = 0;
        if (i == 0) break;
    }
    return DataTable(axes, values);
}

TEST(DataTable, GivesMultilinearFunctionsBackInAnyNumberOfDimensions) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(0, 2), near(-0.5, 2.25);
    for (std::size_t dimensions = 1; dimensions <= 8; ++dimensions) {
        const DataTable table = multilinear_table(dimensions);
        EXPECT_EQ(table.dimensions(), dimensions);
        for (int n = 0; n < 200; ++n) {
            std::vector<double> point;
            for (std::size_t i = 0; i < dimensions; ++i)
                point.push_back(n % 2 ? inside(random) : near(random));
            const double wanted = multilinear(point);
            EXPECT_NEAR(table.value(point), wanted, 1e-6 * std::abs(wanted) + 1e-6);
        }
    }
}

TEST(DataTable, VectorsAreTheValuesAtThePlacesOfTheLastAxis) {
    const DataTable table = multilinear_table(3);
    const double place[2] = {0.7, -0.3};
    std::vector<double> row(table.last_axis().size(), 99);
    table.vector(place, row);
    const double last[4] = {3, 1, 0.5, 0};
    for (std::size_t k = 0; k < row.size(); ++k) {
        const double point[3] = {place[0], place[1], last[k]};
        EXPECT_NEAR(row[k], table.value(point), 1e-12);
    }
    const DataTable line = multilinear_table(1);
    std::vector<double> all(5);
    line.vector({}, all);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(all[k], 1.25 + 0.25 * static_cast<double>(k), 1e-12);
}

// Values that RADIANCE 6.1's brightdata gives for this table, inside and beyond its ends.
TEST(DataTable, GoesOnAsRadianceDoes) {
    const DataTable table = parse_data("2\n0 10 3\n0 0 4  8 4 2 1\n1 2 3 4\n.5 2.5 1 7\n3 1 2 6\n", "t.dat");
    const double measured[][3] = {
        {2, 3, 2.2},         {7.5, 6, 1.75},       {10, 1, 6},          {-4, 3, 3.1},
        {-5.5, 3, 2.954545}, {-30, 3, 0.5416667},  {14, 1.5, 4},        {15.5, 1.5, 1.290323},
        {40, 1.5, 0.5},      {5, .25, 11.5},       {5, -.5, 3.714286},  {5, -20, 0.5652174},
        {5, 11, -1},         {5, 12.5, -1.333333}, {5, 60, -0.1153846}, {-20, 60, 0.02884615},
        {21, -7, 0.1666667},
    };
    for (const auto& [x, y, value] : measured)
        EXPECT_NEAR(table.value(std::vector{x, y}), value, 2e-6 * std::abs(value)) << x << " " << y;
}

TEST(DataTable, FallsToZeroFarOutside) {
    const DataTable table = parse_data("1  0 1 2  5 7", "t.dat");
    for (const double far : {1e6, -1e6, 1e30, -1e30, 1e300, -1e300})
        EXPECT_NEAR(table.value({&far, 1}), 0, 20 / std::abs(far));
}

TEST(DataTable, SurvivesCoordinatesThatAreNoNumbers) {
    for (const char* text : {"1  0 1 3  5 7 9", "1  0 0 3 1 2 4  5 7 9", "1  0 0 3 4 2 1  5 7 9"}) {
        const DataTable table = parse_data(text, "t.dat");
        for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()}) {
            const DataAxis::Cell cell = table.axis(0).locate(odd);
            EXPECT_LE(cell.index, 1u);
            table.value({&odd, 1});
        }
    }
}

}  // namespace
}  // namespace infra
