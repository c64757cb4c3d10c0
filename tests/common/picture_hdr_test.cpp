#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/format.h"
#include "common/pictures/picture.h"
#include "common/pictures/rgbe.h"
#include "common/text_file.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

/// A picture with runs, noise and black, so that every branch of the coders is used.
std::vector<Rgbe> sample_pixels(int width, int height) {
    std::mt19937 random(7);
    std::vector<Rgbe> pixels(width * height);
    for (int i = 0; i < width * height; ++i) {
        const int x = i % width, y = i / width;
        if (y % 3 == 0) pixels[i] = {std::uint8_t(128 + random() % 128), std::uint8_t(random()), 9, 130};
        if (y % 3 == 1) pixels[i] = {200, std::uint8_t(x / 3), std::uint8_t(x / 300), 127};
        if (y % 3 == 2 && x > width / 2) pixels[i] = {255, 255, 255, 140};
    }
    return pixels;
}

Picture picture_of(const std::vector<Rgbe>& pixels, int width, int height) {
    Picture picture{.width = width, .height = height};
    for (const Rgbe& pixel : pixels)
        for (const float value : from_rgbe(pixel)) picture.pixels.push_back(value);
    return picture;
}

std::string file_start(int width, int height, const std::string& format = "32-bit_rle_rgbe") {
    return "#?RADIANCE\nrpict -ab 1\nFORMAT=" + format + formatted("\n\n-Y %d +X %d\n", height, width);
}

void append(std::string& bytes, const Rgbe& pixel) { bytes.append(pixel.begin(), pixel.end()); }

std::string flat_file(const std::vector<Rgbe>& pixels, int width, int height) {
    std::string bytes = file_start(width, height);
    for (const Rgbe& pixel : pixels) append(bytes, pixel);
    return bytes;
}

/// The run lengths of RADIANCE 1.x: (1,1,1,n) repeats the pixel before it, counts over 255 take several.
std::string old_file(const std::vector<Rgbe>& pixels, int width, int height) {
    std::string bytes = file_start(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width;) {
            const Rgbe& pixel = pixels[y * width + x];
            int repeats = 0;
            while (x + repeats + 1 < width && pixels[y * width + x + repeats + 1] == pixel) ++repeats;
            append(bytes, pixel);
            for (int rest = repeats; rest > 0; rest >>= 8) append(bytes, {1, 1, 1, std::uint8_t(rest & 255)});
            x += repeats + 1;
        }
    return bytes;
}

TEST(Hdr, ReadsAllThreeEncodingsAlike) {
    const TemporaryFolder folder;
    for (const int width : {1, 7, 8, 16, 17, 130, 700}) {
        const auto pixels = sample_pixels(width, 5);
        const Picture expected = picture_of(pixels, width, 5);
        write_file(folder / "flat.hdr", flat_file(pixels, width, 5));
        write_file(folder / "old.hdr", old_file(pixels, width, 5));
        write_hdr(folder / "new.hdr", expected);
        for (const char* name : {"flat.hdr", "old.hdr", "new.hdr"}) {
            const Picture read = read_picture(folder / name);
            EXPECT_EQ(read.width, width) << name;
            EXPECT_EQ(read.height, 5) << name;
            EXPECT_EQ(read.pixels, expected.pixels) << name << " width " << width;
        }
    }
}

TEST(Hdr, WritesRunLengthsAsRadianceDoes) {
    const TemporaryFolder folder;
    Picture picture{.width = 20, .height = 1};
    for (int x = 0; x < 20; ++x)
        for (int c = 0; c < 3; ++c) picture.pixels.push_back(c == 0 && x < 2 ? 0.75f : 1.0f);
    write_hdr(folder / "p.hdr", picture);
    const std::string bytes = read_text_file(folder / "p.hdr");
    const std::string start = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y        1 +X       20\n";
    ASSERT_EQ(bytes.substr(0, start.size()), start);
    const std::string expected{2,         2,         0,         20,         // new format, width 20
                               char(130), 96,        char(146), char(128),  // two of 96, eighteen of 128
                               char(148), char(128), char(148), char(128),  // green and blue: one run
                               char(148), char(129)};                       // exponents
    EXPECT_EQ(bytes.substr(start.size()), expected);
}

TEST(Hdr, KeepsHeaderLinesInOrder) {
    const TemporaryFolder folder;
    Picture picture{.width = 2, .height = 1, .pixels = std::vector<float>(6, 1.0f)};
    picture.header.lines = {"oconv a.rad",
                            "rpict -vp 1 2 3 -vd 0 0 -1 -vu 0 1 0",
                            "EXPOSURE=2",
                            "\tVIEW= -vp 9 9 9",
                            "VIEW= -vtl -vh 3",
                            "EXPOSURE= 1.5",
                            "PIXASPECT=0.5",
                            "COLORCORR= 1 2 4",
                            "PRIMARIES= .64 .33 .29 .6 .15 .06 .3333 .3333"};
    write_hdr(folder / "p.hdr", picture);
    Picture read = read_picture(folder / "p.hdr");
    EXPECT_EQ(read.header.lines, picture.header.lines);
    EXPECT_DOUBLE_EQ(read.header.exposure(), 3);
    EXPECT_DOUBLE_EQ(read.header.pixel_aspect(), 0.5);
    EXPECT_DOUBLE_EQ(read.header.color_correction()[2], 4);
    EXPECT_DOUBLE_EQ(read.header.primaries().value()[2], .29);
    EXPECT_EQ(read.header.value("EXPOSURE"), "1.5");
    EXPECT_FALSE(read.header.value("GAMMA"));
    const View view = read.header.view().value();
    EXPECT_EQ(view.type, ViewType::parallel);
    EXPECT_EQ(view.point.y, 2);
    EXPECT_EQ(view.horizontal, 3);

    undo_exposure(read);
    EXPECT_FLOAT_EQ(read.pixels[0], 1.00390625f / 3);
    EXPECT_FLOAT_EQ(read.pixels[2], 1.00390625f / 12);
    EXPECT_DOUBLE_EQ(read.header.exposure(), 1);
}

TEST(Hdr, ReadsXyzeAndSpectra) {
    const TemporaryFolder folder;
    std::string xyz = file_start(1, 1, "32-bit_rle_xyze");
    append(xyz, {128, 128, 128, 129});
    write_file(folder / "xyz.hdr", xyz);
    EXPECT_EQ(read_picture(folder / "xyz.hdr").space, ColorSpace::xyz);

    std::string spectrum = "#?RADIANCE\nNCOMP=5\nFORMAT=Radiance_spectra\n\n-Y 1 +X 2\n";
    spectrum += std::string{1, 2, 3, 4, char(200), char(136), 0, 0, 0, 0, 5, char(136)};
    write_file(folder / "s.hdr", spectrum);
    const Picture picture = read_picture(folder / "s.hdr");
    EXPECT_EQ(picture.channels, 5);
    EXPECT_EQ(picture.at(0, 0)[4], 200.5f);
    EXPECT_EQ(picture.at(1, 0)[4], 5.5f);
}

TEST(Hdr, TurnsEveryScanlineOrderUpright) {
    const TemporaryFolder folder;
    // 3 x 2 pixels, red mantissa 128 + column + 10 * row from the top.
    const char* orders[] = {"-Y 2 +X 3", "+Y 2 +X 3", "-Y 2 -X 3", "+Y 2 -X 3",
                            "+X 3 -Y 2", "+X 3 +Y 2", "-X 3 -Y 2", "-X 3 +Y 2"};
    for (const std::string order : orders) {
        const bool y_major = order[1] == 'Y';
        const bool x_decreases = order[y_major ? 5 : 0] == '-', y_decreases = order[y_major ? 0 : 5] == '-';
        std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + order + "\n";
        for (int i = 0; i < 6; ++i) {
            int column = y_major ? i % 3 : i / 2, step = y_major ? i / 3 : i % 2;
            if (x_decreases) column = 2 - column;
            const int row = y_decreases ? step : 1 - step;
            append(bytes, {std::uint8_t(128 + column + 10 * row), 0, 0, 136});
        }
        write_file(folder / "p.hdr", bytes);
        const Picture picture = read_picture(folder / "p.hdr");
        ASSERT_EQ(picture.width, 3) << order;
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 3; ++column)
                EXPECT_EQ(picture.at(column, row)[0], 128.5f + column + 10 * row) << order;
    }
}

TEST(Hdr, MalformedFilesGiveOneClearLine) {
    const TemporaryFolder folder;
    const std::string path = folder / "p.hdr";
    const auto error_for = [&](const std::string& bytes) {
        write_file(path, bytes);
        return error_of([&] { read_picture(path); });
    };
    const std::string at = path + ": ";
    EXPECT_EQ(error_for("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"), at + "bad picture: the header is cut short");
    EXPECT_EQ(error_for("#?RADIANCE\nFORMAT=float\n\n-Y 1 +X 1\n"),
              at + "unknown picture format \"float\" (known are 32-bit_rle_rgbe, 32-bit_rle_xyze and "
                   "Radiance_spectra)");
    EXPECT_EQ(error_for("#?RADIANCE\n\n"), at + "bad picture: no resolution line such as \"-Y 480 +X 640\"");
    EXPECT_EQ(error_for("#?RADIANCE\n\n-Y 2 +Y 2\n"),
              at + "bad picture: no resolution line such as \"-Y 480 +X 640\"");
    EXPECT_EQ(error_for("#?RADIANCE\n\n-Y 0 +X 2\n"), at + "bad picture: illegal resolution \"-Y 0 +X 2\"");
    EXPECT_EQ(error_for("#?RADIANCE\n\n-Y -5 +X 2\n"), at + "bad picture: illegal resolution \"-Y -5 +X 2\"");
    EXPECT_EQ(error_for("#?RADIANCE\n\n-Y 99999999999 +X 2\n"),
              at + "bad picture: illegal resolution \"-Y 99999999999 +X 2\"");
    EXPECT_EQ(error_for("#?RADIANCE\n\n-Y 1000000 +X 1000000\n"),
              at + "bad picture: it is larger than we can hold");
    EXPECT_EQ(error_for("#?RADIANCE\nNCOMP=two\nFORMAT=Radiance_spectra\n\n-Y 1 +X 1\n"),
              at + "bad picture: a spectral one needs NCOMP= and a number from 3 to 4096");

    const auto pixels = sample_pixels(40, 3);
    const std::string flat = flat_file(pixels, 40, 3);
    EXPECT_EQ(error_for(flat.substr(0, flat.size() - 1)), at + "bad picture: scanline 3 is cut short");
    EXPECT_EQ(error_for(file_start(40, 3)), at + "bad picture: scanline 1 is cut short");
    EXPECT_EQ(error_for(file_start(20, 1) + std::string{2, 2, 0, 21}),
              at + "bad picture: scanline 1 has the wrong length");
    EXPECT_EQ(error_for(file_start(20, 1) + std::string{2, 2, 0, 20, char(255), 7}),
              at + "bad picture: scanline 1 is malformed: a run does not fit");
    EXPECT_EQ(error_for(file_start(20, 1) + std::string{2, 2, 0, 20, 0, 7}),
              at + "bad picture: scanline 1 is malformed: a run does not fit");
    EXPECT_EQ(error_for(file_start(20, 1) + std::string{9, 9, 9, 9} + std::string(40, 1)),
              "no error");  // a count past the end is cut off, as RADIANCE does
    EXPECT_EQ(error_for(file_start(20, 1) + std::string{9, 9, 9, 9} +
                        std::string{1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}),
              at + "bad picture: scanline 1 is malformed: a repeat count does not end");
    EXPECT_EQ(error_of([&] { read_picture(folder / "none.hdr"); }),
              "cannot open picture \"" + (folder / "none.hdr") + "\": No such file or directory");
}

TEST(Hdr, CompleteRowsOfAnyTruncationAreRead) {
    Picture picture{.width = 9, .height = 5};
    for (int i = 0; i < 9 * 5 * 3; ++i) picture.pixels.push_back(1.0f + float(i % 7));
    TemporaryFolder folder;
    const std::string path = folder / "cut.hdr";
    write_hdr(path, picture);
    const Picture whole = read_picture(path);
    const std::string bytes = read_text_file(path);
    const std::size_t start = bytes.find("+X") + 2;
    int most = 0;
    for (std::size_t size = bytes.find('\n', start) + 1; size <= bytes.size(); ++size) {
        write_file(path, bytes.substr(0, size));
        std::FILE* const file = std::fopen(path.c_str(), "rb");
        const UnfinishedRows found = read_unfinished_hdr(file, path);
        std::fclose(file);
        EXPECT_EQ(found.height, 5);
        EXPECT_GE(found.rows.height, most);
        most = found.rows.height;
        ASSERT_EQ(found.rows.pixels.size(), std::size_t(most) * 9 * 3);
        EXPECT_TRUE(std::equal(found.rows.pixels.begin(), found.rows.pixels.end(), whole.pixels.begin()));
        EXPECT_EQ(most == 5, size == bytes.size());
    }
    write_file(path, bytes.substr(0, start));
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    EXPECT_NE(error_of([&] { read_unfinished_hdr(file, path); }), "no error");
    std::fclose(file);
}

TEST(Hdr, EveryTruncationIsAnError) {
    const TemporaryFolder folder;
    write_hdr(folder / "p.hdr", picture_of(sample_pixels(50, 4), 50, 4));
    const std::string whole = read_text_file(folder / "p.hdr");
    for (std::size_t size = 2; size < whole.size(); ++size) {
        write_file(folder / "t.hdr", whole.substr(0, size));
        EXPECT_THROW(read_picture(folder / "t.hdr"), Error) << size;
    }
}

TEST(Hdr, RandomDamageNeverCrashes) {
    const TemporaryFolder folder;
    write_hdr(folder / "p.hdr", picture_of(sample_pixels(50, 4), 50, 4));
    const std::string whole = read_text_file(folder / "p.hdr");
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        std::string damaged = whole;
        for (int k = 0; k < 3; ++k) damaged[2 + random() % (damaged.size() - 2)] = char(random());
        write_file(folder / "d.hdr", damaged);
        error_of([&] { read_picture(folder / "d.hdr"); });
    }
}

TEST(Hdr, WriterRefusesWhatDoesNotFit) {
    const TemporaryFolder folder;
    std::FILE* file = std::fopen((folder / "p.hdr").c_str(), "wb");
    HdrWriter writer(file, {}, 4, 1);
    const std::vector<float> row(12, 1.0f);
    EXPECT_EQ(error_of([&] { writer.write_scanline(std::vector<float>(11)); }),
              "scanline does not fit the picture");
    EXPECT_EQ(error_of([&] { writer.finish(); }), "picture is missing scanlines");
    writer.write_scanline(row);
    EXPECT_EQ(error_of([&] { writer.write_scanline(row); }), "scanline does not fit the picture");
    writer.finish();
    std::fclose(file);
    EXPECT_EQ(error_of([&] {
                  write_hdr(folder / "q.hdr", {.width = 1, .height = 1, .channels = 2, .pixels = {1, 2}});
              }),
              (folder / "q.hdr") +
                  ": an .hdr picture has 1 or 3 channels, or bands of wavelengths (write .exr instead)");
}

}  // namespace
}  // namespace infra
