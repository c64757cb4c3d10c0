#include "common/pictures/picture_table.h"

#include <gtest/gtest.h>

#include "common/pictures/picture.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;

// Red counts columns, green rows from the top.
Picture numbered(int width, int height) {
    Picture picture{.width = width, .height = height};
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (const int value : {column, row, 7}) picture.pixels.push_back(static_cast<float>(value));
    return picture;
}

std::vector<double> color(const DataTable& table, double u, double v) {
    std::vector<double> rgb(3);
    const double place[2] = {u, v};
    table.vector(place, rgb);
    return rgb;
}

void expect_color(const DataTable& table, double u, double v, double column, double row) {
    const std::vector<double> rgb = color(table, u, v);
    EXPECT_NEAR(rgb[0], column, 1e-5) << u << " " << v;
    EXPECT_NEAR(rgb[1], row, 1e-5) << u << " " << v;
    EXPECT_NEAR(rgb[2], 7, 1e-5);
}

TEST(PictureTable, SpansTheShorterSideFromZeroToOneAndStartsAtTheLowerLeft) {
    const TemporaryFolder folder;
    write_exr(folder / "wide.exr", numbered(9, 5), {});
    const DataTable wide = read_color_table(folder / "wide.exr");
    expect_color(wide, 0, 0, 0, 4);
    expect_color(wide, 0, 1, 0, 0);
    expect_color(wide, 9.0 / 5, 0, 8, 4);
    expect_color(wide, 0.9, 0.625, 4, 1.5);
    write_exr(folder / "tall.exr", numbered(5, 9), {});
    const DataTable tall = read_color_table(folder / "tall.exr");
    expect_color(tall, 1, 9.0 / 5, 4, 0);
    expect_color(tall, 0.5, 0.9, 2, 4);
}

TEST(PictureTable, KeepsTheExposureAndHeedsTheShapeOfPixels) {
    const TemporaryFolder folder;
    Picture picture = numbered(5, 4);
    picture.header.add("EXPOSURE=8");
    picture.header.add("PIXASPECT= .5");
    write_exr(folder / "p.exr", picture, {});
    const DataTable table = read_color_table(folder / "p.exr");
    expect_color(table, 5 / (4 * 0.5), 1, 4, 0);
    expect_color(table, 0, 0, 0, 3);
}

TEST(PictureTable, TakesOneChannelForThree) {
    const TemporaryFolder folder;
    Picture grey{.width = 2, .height = 2, .channels = 1, .pixels = {1, 2, 3, 4}};
    write_exr(folder / "grey.exr", grey, {});
    EXPECT_EQ(color(read_color_table(folder / "grey.exr"), 1, 0), (std::vector<double>{4, 4, 4}));
}

std::string spectral_file(const std::string& splits) {
    std::string bytes = "#?RADIANCE\nNCOMP=4\n" + splits + "FORMAT=Radiance_spectra\n\n-Y 2 +X 2\n";
    for (int pixel = 0; pixel < 4; ++pixel)
        for (const int c : {16 * pixel, 60, 80, 100, 136}) bytes += static_cast<char>(c);
    return bytes;
}

TEST(PictureTable, KnowsTheWavelengthsOfSpectra) {
    const TemporaryFolder folder;
    test::write_file(folder / "p.hsr", spectral_file("WAVELENGTH_SPLITS= 12000 10666.7 9333.33 8000\n"));
    const DataTable table = read_spectrum_table(folder / "p.hsr");
    EXPECT_EQ(table.dimensions(), 3u);
    EXPECT_EQ(table.last_axis().begin(), 11500);
    EXPECT_EQ(table.last_axis().end(), 8500);
    const double lower_right[3] = {1, 0, 11500}, upper_left[3] = {0, 1, 9000};
    EXPECT_EQ(table.value(lower_right), 48.5);
    EXPECT_EQ(table.value(upper_left), 0.5 * (80.5 + 100.5) + 0.0);
}

TEST(PictureTable, TakesSpectralOpenExr) {
    const TemporaryFolder folder;
    Picture picture{.width = 2, .height = 2, .channels = 4, .space = ColorSpace::spectrum};
    for (int i = 0; i < 16; ++i) picture.pixels.push_back(static_cast<float>(i));
    picture.bands = Channels::spectral(4, 8000, 12000);
    write_exr(folder / "p.exr", picture, {});
    const DataTable table = read_spectrum_table(folder / "p.exr");
    const double upper_right[3] = {1, 1, 9500};
    EXPECT_EQ(table.value(upper_right), 6);
}

TEST(PictureTable, SaysWhyItRefuses) {
    const TemporaryFolder folder;
    const auto refused = [&](DataTable (*read)(const std::string&), const std::string& what) {
        const std::string message = error_of([&] { read(folder / "p"); });
        EXPECT_NE(message.find(what), std::string::npos) << message;
        EXPECT_NE(message.find(folder / "p"), std::string::npos) << message;
    };
    refused(read_color_table, "cannot open picture");
    test::write_file(folder / "p", "no picture");
    refused(read_color_table, "cannot read picture");
    test::write_file(folder / "p", spectral_file(""));
    refused(read_color_table, "a picture of 4 channels is not one of colours (specpict takes");
    refused(read_spectrum_table, "does not say what its wavelengths are");
    test::write_file(folder / "p", spectral_file("WAVELENGTH_SPLITS= 400 500 600 700\n"));
    refused(read_spectrum_table, "does not say what its wavelengths are");
    test::write_file(folder / "p",
                     "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string(8, '\1'));
    refused(read_color_table, "a picture of 2 x 1 pixels is too small");
    const std::string pixels(16, '\1');
    test::write_file(folder / "p", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 2\n" + pixels);
    refused(read_color_table, "an XYZ picture where RGB is needed");
    test::write_file(folder / "p", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + pixels);
    refused(read_spectrum_table, "this is no spectral picture");
}

}  // namespace
}  // namespace infra
