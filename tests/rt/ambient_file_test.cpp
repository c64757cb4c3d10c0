// Files of cached irradiance: what is written is read, by several at once, and nothing else is taken for one.
#include "rt/ambient/ambient_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <vector>

#include "../common/test_files.h"

namespace infra {
namespace {

using test::error_of;

IrradianceValue example(int channels, double x) {
    IrradianceValue value(channels);
    value.point = {x, -2.5, 1e-3};
    value.normal = {0.6, 0, -0.8};
    value.axis = {0, 1, 0};
    value.level = 2;
    value.weight = 0.25;
    value.radius[0] = 0.125;
    value.radius[1] = 0.2;
    value.gradient[0] = -0.7;
    value.gradient[1] = 0.01;
    value.turn[0] = 0.3;
    value.turn[1] = -1.5;
    value.walls = 0x80000001u;
    for (int c = 0; c < channels; ++c) value.radiance.set(c, 1.0f + 0.25f * static_cast<float>(c));
    return value;
}

struct Ambient : testing::Test {
    test::TemporaryFolder folder;
    std::string path = folder / "a.amb";
    std::vector<std::string> warnings;
    WarningSink warn = [this](std::string_view text) { warnings.emplace_back(text); };

    std::vector<IrradianceValue> read(const Channels& channels = {}) {
        std::vector<IrradianceValue> values;
        AmbientFile(path, channels, {}, warn).read_new([&](const IrradianceValue& v) {
            values.push_back(v);
        });
        return values;
    }
    void write(int count, const Channels& channels = {}) {
        AmbientFile file(path, channels, {"rpict -aa .1"}, warn);
        file.read_new([](const IrradianceValue&) {});
        for (int i = 0; i < count; ++i) file.append(example(channels.count(), i));
        file.exchange([](const IrradianceValue&) {});
    }
    std::string bytes() const {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
};

TEST_F(Ambient, GivesBackWhatItWasGiven) {
    write(3);
    EXPECT_TRUE(
        bytes().starts_with("#?RADIANCE\nrpict -aa .1\nWAVELENGTH_SPLITS= 780 588 480 380\nNCOMP=3\n"
                            "FORMAT=Radiance_ambval\n\n\x02\x31"))
        << bytes();
    const auto values = read();
    ASSERT_EQ(values.size(), 3u);
    const IrradianceValue &v = values[2], e = example(3, 2);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(v.point[i], e.point[i], 1e-8);
        EXPECT_NEAR(v.normal[i], e.normal[i], 1e-4);
        EXPECT_NEAR(v.axis[i], e.axis[i], 1e-4);
        EXPECT_NEAR(v.radiance[i], e.radiance[i], 0.01);
    }
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(v.radius[i], e.radius[i], 1e-9);
        EXPECT_NEAR(v.gradient[i], e.gradient[i], 1e-9);
        EXPECT_NEAR(v.turn[i], e.turn[i], 1e-8);
    }
    EXPECT_EQ(v.level, 2);
    EXPECT_NEAR(v.weight, 0.25, 1e-9);
    EXPECT_EQ(v.walls, 0x80000001u);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Ambient, TwoWritersSeeEachOther) {
    std::size_t first_got = 0, second_got = 0;
    AmbientFile first(path, {}, {}, warn), second(path, {}, {}, warn);
    first.append(example(3, 1));
    first.append(example(3, 2));
    first.exchange([&](const IrradianceValue&) { ++first_got; });
    second.append(example(3, 3));
    second.exchange([&](const IrradianceValue&) { ++second_got; });
    first.append(example(3, 4));
    first.exchange([&](const IrradianceValue&) { ++first_got; });
    EXPECT_EQ(first_got, 1u);
    EXPECT_EQ(second_got, 2u);
    EXPECT_EQ(read().size(), 4u);
}

TEST_F(Ambient, KeepsSpectralChannelsAndConvertsOthers) {
    const Channels bands = Channels::spectral(8, 8000, 12000);
    write(1, bands);
    const auto values = read(bands);
    ASSERT_EQ(values.size(), 1u);
    for (int c = 0; c < 8; ++c) EXPECT_NEAR(values[0].radiance[c], 1 + 0.25 * c, 0.02);
    EXPECT_TRUE(warnings.empty());

    const auto halves = read(Channels::spectral(4, 8000, 12000));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("are converted"), std::string::npos) << warnings[0];
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(halves[0].radiance[c], 1.125 + 0.5 * c, 0.02);
}

TEST_F(Ambient, DropsAnUnfinishedValueAtTheEnd) {
    write(2);
    const std::string whole = bytes();
    test::write_file(path, whole + "half a val");
    EXPECT_EQ(read().size(), 2u);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("the last 10 bytes are no whole value"), std::string::npos) << warnings[0];
    EXPECT_EQ(bytes(), whole);
}

TEST_F(Ambient, RefusesWhatMakesNoSense) {
    write(2);
    const std::string good = bytes();
    constexpr std::size_t record = 67;
    const auto refusal = [&](const std::string& text) {
        test::write_file(path, text);
        const std::string message = error_of([&] { read(); });
        EXPECT_EQ(bytes(), text) << "a file that is refused is left as it is";
        return message;
    };
    std::string zeros = good;
    zeros.replace(good.size() - record, record, record, '\0');
    EXPECT_NE(refusal(zeros).find("makes no sense (remove the file to start again)"), std::string::npos);
    std::string wrong_magic = good;
    wrong_magic[good.find("\n\n") + 2] = 3;
    EXPECT_NE(refusal(wrong_magic).find("this is no ambient file"), std::string::npos);
    EXPECT_NE(refusal("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n").find("this is no ambient file"),
              std::string::npos);
    EXPECT_NE(refusal("void plastic red 0 0 5 1 0 0 0 0\n").find("this is no ambient file"),
              std::string::npos);
    EXPECT_NE(refusal(good.substr(0, 30)).find("truncated ambient file"), std::string::npos);
    std::string many = good;
    many.replace(good.find("NCOMP=3"), 7, "NCOMP=999");
    EXPECT_NE(refusal(many).find("damaged ambient file: NCOMP=999"), std::string::npos);
}

TEST_F(Ambient, SaysWhenAFileCannotBeMade) {
    path = folder / "nowhere/a.amb";
    EXPECT_NE(error_of([&] { read(); }).find("a.amb: ambient file cannot be opened: No such file"),
              std::string::npos);
}

}  // namespace
}  // namespace infra
