// irview -K and -C as their users run them.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "common/pictures/picture.h"
#include "common/planck/planck.h"
#include "programs/command.h"

namespace infra::ir {
namespace {

using test::Folder;
using test::Outcome;
using test::run;

/// Black surfaces from 280 K on, 1 K a column, in 8..12 um; one channel or three of the same.
Picture warm_picture(int channels) {
    Picture picture{.width = 30, .height = 20, .channels = channels};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.pixels.insert(picture.pixels.end(), std::size_t(channels),
                                  static_cast<float>(band_radiance(280 + x, 8, 12)));
    return picture;
}

class IrviewTemperature : public testing::Test {
  protected:
    void SetUp() override {
        write_exr(folder_.path("plain.exr"), warm_picture(3), {});
        write_exr(folder_.path("banded.exr"), warm_picture(1), {.quantity = "radiance", .band = "8-12 um"});
        folder_.write("flat.txt", "8 1\n12 1\n");
    }

    Folder folder_;
};

TEST_F(IrviewTemperature, WritesFloatTemperatures) {
    const std::pair<const char*, double> cases[] = {{"-K -band 8 12 -o t.exr plain.exr", 280},
                                                    {"-K -o t.exr banded.exr", 280},
                                                    {"-K -response flat.txt -o t.exr plain.exr", 280},
                                                    {"-C -band 8 12 -o t.exr plain.exr", 6.85}};
    for (const auto& [arguments, first] : cases) {
        const Outcome outcome = run(folder_, std::string("irview ") + arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const Picture picture = read_picture(folder_.path("t.exr"));
        ASSERT_EQ(picture.channels, 1);
        for (int x = 0; x < picture.width; ++x)
            EXPECT_NEAR(picture.at(x, 7)[0], first + x, 1e-4) << arguments;
        EXPECT_EQ(picture.header.value("UNIT"), first == 280 ? "K" : "degC");
        EXPECT_EQ(picture.header.value("QUANTITY"), "apparent temperature");
        EXPECT_EQ(picture.header.value("BAND"), std::string(arguments).find("response") == std::string::npos
                                                    ? "8-12 um"
                                                    : "response flat.txt");
    }
}

TEST_F(IrviewTemperature, FindsTheBandInARadiancePictureToo) {
    Picture picture = warm_picture(3);
    picture.header.lines = {"rpict", "BAND= 8-12 um"};
    write_hdr(folder_.path("warm.hdr"), picture);
    const Outcome outcome = run(folder_, "irview -K -o t.exr warm.hdr");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(read_picture(folder_.path("t.exr")).at(20, 3)[0], 300, 0.5);  // RGBE's steps
}

TEST_F(IrviewTemperature, MeasuresRegionsInTemperature) {
    const Outcome outcome = run(folder_, "irview -K -stats -region 10 0 13 2 mast banded.exr");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out.rfind("# apparent temperature, K, 8-12 um\n# region\t", 0), 0u) << outcome.out;
    char label[20];
    int channel = 0, count = 0;
    double mean = 0, deviation = 0, least = 0, most = 0;
    const std::string row = outcome.out.substr(outcome.out.find("mast"));
    ASSERT_EQ(std::sscanf(row.c_str(), "%19s %d %d %lf %lf %lf %lf", label, &channel, &count, &mean,
                          &deviation, &least, &most),
              7);
    EXPECT_EQ(count, 6);
    EXPECT_NEAR(mean, 291, 1e-4);
    EXPECT_NEAR(deviation, std::sqrt(4.0 / 5), 1e-4);
    EXPECT_NEAR(least, 290, 1e-4);
    EXPECT_NEAR(most, 292, 1e-4);
}

TEST_F(IrviewTemperature, EachPaletteGivesAPictureOfItsOwn) {
    std::string before;
    for (const char* palette : {"inferno", "magma", "viridis", "white-hot", "black-hot"}) {
        const Outcome outcome =
            run(folder_, std::string("irview -C -o t.png -palette ") + palette + " banded.exr");
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const std::string picture = folder_.read("t.png");
        EXPECT_NE(picture, before);
        before = picture;
    }
    const Picture hot_is_black = read_picture(folder_.path("t.png"));
    const int row = hot_is_black.height / 2;
    EXPECT_FLOAT_EQ(hot_is_black.at(0, row)[0], 1);
    EXPECT_FLOAT_EQ(hot_is_black.at(29, row)[0], 0);
}

TEST_F(IrviewTemperature, SaysHowManyPixelsHaveNoTemperature) {
    Picture picture = warm_picture(1);
    picture.at(3, 2)[0] = 0;
    picture.at(4, 2)[0] = -1;
    write_exr(folder_.path("hole.exr"), picture, {.band = "8-12 um"});
    const Outcome outcome = run(folder_, "irview -K -o t.exr hole.exr");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "irview: warning: hole.exr: 2 pixels have no temperature, the first is 3 2\n");
    EXPECT_TRUE(std::isnan(read_picture(folder_.path("t.exr")).at(3, 2)[0]));
}

TEST_F(IrviewTemperature, MeasuresThePixelsThatHaveATemperature) {
    Picture picture = warm_picture(1);
    picture.at(3, 2)[0] = 0;
    picture.at(4, 2)[0] = -1;
    write_exr(folder_.path("hole.exr"), picture, {.band = "8-12 um"});
    const Outcome outcome = run(folder_, "irview -K -stats -region 3 2 6 3 mast hole.exr");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("mast\t0\t1\t28"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err,
              "irview: warning: hole.exr: region mast: 2 of 3 pixels have no temperature and are left out\n");
    const Outcome none = run(folder_, "irview -K -stats -region 3 2 5 3 mast hole.exr");
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(none.out, "");
    EXPECT_EQ(none.err, "irview: hole.exr: region mast has no pixel with a value in channel 0\n");
}

TEST_F(IrviewTemperature, RefusesInOneLineAndWritesNothing) {
    ASSERT_EQ(run(folder_, "irview -K -o kelvin.exr banded.exr").status, 0);
    write_exr(folder_.path("odd.exr"), warm_picture(1), {.band = "LWIR"});
    folder_.write("bad.txt", "9 1\n8 1\n");
    const std::string hint = " (-band 8 12 gives it in um, -response file a spectral response)";
    const std::pair<const char*, std::string> cases[] = {
        {"-K plain.exr", "plain.exr: the picture names no band" + hint},
        {"-K odd.exr", "odd.exr: the picture's band: \"LWIR\" is not a band" + hint},
        {"-K -C banded.exr", "command line error at '-C': -K and -C exclude one another"},
        {"-K -band 12 8 banded.exr",
         "band 12..8 um is empty or reversed (give the shorter wavelength first, in micrometres)"},
        {"-K -response bad.txt banded.exr", "bad.txt:2: wavelength 8 um does not come after 9 um"},
        {"-K -band 8 12 -response flat.txt banded.exr",
         "command line error at '-response flat.txt': there is a band or response already"},
        {"-band 8 12 plain.exr", "a band or response is for apparent temperatures (-K or -C asks for them)"},
        {"-K kelvin.exr", "the picture holds apparent temperature, not radiance (-K and -C need radiance)"},
    };
    for (const auto& [arguments, expected] : cases) {
        const Outcome outcome = run(folder_, std::string("irview -o t.png -stats ") + arguments);
        EXPECT_EQ(outcome.err, "irview: " + expected + "\n") << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(outcome.status, 1) << arguments;
        EXPECT_FALSE(folder_.has("t.png")) << arguments;
    }
}

}  // namespace
}  // namespace infra::ir
