#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "common/pictures/image8.h"
#include "common/pictures/picture.h"
#include "common/text_file.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;

Picture ramp(int width, int height, int channels) {
    Picture picture{.width = width, .height = height, .channels = channels};
    for (int i = 0; i < width * height * channels; ++i) picture.pixels.push_back(0.1f + 1.7f * float(i));
    picture.header.lines = {"oconv a.rad", "VIEW= -vtl -vh 3 -vv 2", "SOFTWARE= x"};
    return picture;
}

TEST(Exr, KeepsEveryBitAndTheHeader) {
    const TemporaryFolder folder;
    for (const int channels : {1, 3, 12}) {
        const Picture picture = ramp(19, 11, channels);
        write_exr(folder / "p.exr", picture, {});
        const Picture read = read_picture(folder / "p.exr");
        ASSERT_EQ(read.channels, channels);
        EXPECT_EQ(read.width, 19);
        EXPECT_EQ(read.height, 11);
        EXPECT_EQ(read.pixels, picture.pixels) << channels << " channels";
        EXPECT_EQ(read.header.lines, picture.header.lines);
        EXPECT_EQ(read.header.view().value().type, ViewType::parallel);
    }
}

TEST(Exr, DescribesItself) {
    const TemporaryFolder folder;
    Picture picture = ramp(4, 4, 3);
    picture.header.add("PIXASPECT=2");
    write_exr(folder / "p.exr", picture,
              {.program = "rpict -ab 1 a.oct",
               .view = " -vtv -vp 0 0 0",
               .quantity = "radiance",
               .unit = "W.m-2.sr-1",
               .band = "8-12 um",
               .software = "Infradiance"});
    const auto input = OIIO::ImageInput::open(folder / "p.exr");
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.format, OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(spec.get_string_attribute("compression"), "zip");
    EXPECT_EQ(spec.get_string_attribute("unit"), "W.m-2.sr-1");
    EXPECT_EQ(spec.get_string_attribute("quantity"), "radiance");
    EXPECT_EQ(spec.get_string_attribute("band"), "8-12 um");
    EXPECT_EQ(spec.get_string_attribute("VIEW"), " -vtv -vp 0 0 0");
    EXPECT_EQ(spec.get_string_attribute("program"), "rpict -ab 1 a.oct");
    EXPECT_FLOAT_EQ(spec.get_float_attribute("PixelAspectRatio"), 0.5f);
}

TEST(Exr, FailuresLeaveNoFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(error_of([&] { write_exr(folder / "p.exr", {}, {}); }),
              (folder / "p.exr") + ": a picture needs at least one pixel");
    EXPECT_EQ(error_of([&] { write_exr(folder / "no/p.exr", ramp(2, 2, 3), {}); }),
              "cannot write \"" + (folder / "no/p.exr") + "\": No such file or directory");
    EXPECT_EQ(folder.file_count(), 0u);
}

TEST(Exr, ReadsHalvesAndLeavesAlphaOut) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(5, 70, 4, OIIO::TypeDesc::HALF);
    spec.channelnames = {"R", "G", "B", "A"};
    std::vector<float> pixels;
    for (int i = 0; i < 5 * 70; ++i)
        for (const float value : {0.5f * static_cast<float>(i), 2.0f, -1.0f, 0.25f}) pixels.push_back(value);
    const auto output = OIIO::ImageOutput::create(folder / "p.exr");
    ASSERT_TRUE(output && output->open(folder / "p.exr", spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
    const Picture read = read_picture(folder / "p.exr");
    ASSERT_EQ(read.channels, 3);
    EXPECT_EQ(read.space, ColorSpace::rgb);
    EXPECT_EQ(read.at(4, 69)[0], 174.5f);
    EXPECT_EQ(read.at(4, 69)[1], 2.0f);
    EXPECT_EQ(read.at(0, 66)[2], -1.0f);
}

TEST(Exr, CutFilesAreRefused) {
    const TemporaryFolder folder;
    write_exr(folder / "p.exr", ramp(40, 300, 3), {});
    const std::string whole = read_text_file(folder / "p.exr");
    for (const std::size_t kept : {std::size_t{4}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        write_file(folder / "cut.exr", whole.substr(0, kept));
        const std::string error = error_of([&] { read_picture(folder / "cut.exr"); });
        EXPECT_EQ(error.find((folder / "cut.exr") + ": cannot read picture: "), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(FloatPictures, AreRadiancesAndOpenExr) {
    const TemporaryFolder folder;
    write_exr(folder / "p.exr", ramp(3, 3, 3), {});
    write_hdr(folder / "p.hdr", ramp(3, 3, 3));
    write_png(folder / "p.png", Image8(3, 2));
    EXPECT_EQ(read_float_picture(folder / "p.exr").width, 3);
    EXPECT_EQ(read_float_picture(folder / "p.hdr").width, 3);
    EXPECT_EQ(error_of([&] { read_float_picture(folder / "p.png"); }),
              (folder / "p.png") + ": cannot read picture: it is neither RADIANCE's nor OpenEXR");
}

TEST(ForeignPictures, UnreadableOnesGiveOneLine) {
    const TemporaryFolder folder;
    write_file(folder / "p.exr", "this is no picture");
    const std::string error = error_of([&] { read_picture(folder / "p.exr"); });
    EXPECT_EQ(error.find((folder / "p.exr") + ": cannot read picture: "), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

TEST(Png, ReadsBack) {
    const TemporaryFolder folder;
    Image8 image(3, 2);
    image.at(2, 1) = {255, 0, 51};
    write_png(folder / "p.png", image);
    const Picture read = read_picture(folder / "p.png");
    EXPECT_EQ(read.width, 3);
    EXPECT_FLOAT_EQ(read.at(2, 1)[2], 0.2f);
    EXPECT_FLOAT_EQ(read.at(0, 0)[0], 0.0f);
    EXPECT_EQ(folder.file_count(), 1u);
}

}  // namespace
}  // namespace infra
