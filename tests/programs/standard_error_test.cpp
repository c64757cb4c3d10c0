// rpict -spp and -se: means of samples, and how far they are to be trusted.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "command.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

struct StandardErrors : testing::Test {
    Folder folder;

    void SetUp() override {
        folder.write("room.rad",
                     "void light lum 0 0 3 30 30 30\nlum sphere lamp 0 0 4 0 0 1.6 .2\n"
                     "void plastic white 0 0 5 .7 .6 .5 0 0\nwhite bubble room 0 0 4 0 0 0 4\n"
                     "white sphere ball 0 0 4 1 1 -.5 .7\n");
        ASSERT_EQ(test::run(folder, "oconv room.rad > room.oct").status, 0);
    }
    Outcome rpict(const std::string& options) {
        return test::run(
            folder, "rpict -w -vp 0 -3 0 -vh 60 -vv 60 -x 8 -y 8 -aa 0 -ab 1 -ad 4 -as 0 -dj 1 " + options +
                        " room.oct");
    }
    void expect_refused(const std::string& options, const std::string& why) {
        const Outcome result = rpict(options);
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    }
};

// Against the mean of the other runs, whose own error is small: of normal deviations 68.3 % lie within one.
TEST_F(StandardErrors, are_as_large_as_the_deviations_of_other_seeds) {
    constexpr int runs = 40;
    std::vector<Picture> values, errors;
    for (int seed = 1; seed <= runs; ++seed) {
        ASSERT_EQ(rpict("-spp 64 -se e.exr -o p.exr -seed " + std::to_string(seed)).status, 0);
        values.push_back(read_picture(folder.path("p.exr")));
        errors.push_back(read_picture(folder.path("e.exr")));
    }
    int within = 0, count = 0;
    for (std::size_t i = 0; i < values[0].pixels.size(); ++i) {
        double sum = 0;
        for (const Picture& picture : values) sum += static_cast<double>(picture.pixels[i]);
        for (int r = 0; r < runs; ++r) {
            const double value = static_cast<double>(values[r].pixels[i]),
                         error = static_cast<double>(errors[r].pixels[i]);
            ASSERT_GT(error, 0);
            const double others = (sum - value) / (runs - 1);
            within += std::fabs(value - others) <= error * std::sqrt(1 + 1.0 / (runs - 1));
            ++count;
        }
    }
    // Channels of a pixel go together: a third of them are independent.
    const double deviation = std::sqrt(0.683 * 0.317 / (count / 3.0));
    EXPECT_NEAR(static_cast<double>(within) / count, 0.683, 4 * deviation + 0.01);
}

TEST_F(StandardErrors, do_not_depend_on_threads) {
    ASSERT_EQ(rpict("-spp 5 -n 1 -se e1.exr -o p1.exr").status, 0);
    ASSERT_EQ(rpict("-spp 5 -n 3 -se e3.exr -o p3.exr").status, 0);
    EXPECT_EQ(read_picture(folder.path("p1.exr")).pixels, read_picture(folder.path("p3.exr")).pixels);
    EXPECT_EQ(read_picture(folder.path("e1.exr")).pixels, read_picture(folder.path("e3.exr")).pixels);
}

TEST_F(StandardErrors, are_refused_where_nothing_can_be_said) {
    expect_refused("-se e.exr", "-se needs -spp 2 or more");
    expect_refused("-spp 1 -se e.exr", "-se needs -spp 2 or more");
    expect_refused("-spp 4 -se e.hdr", "e.hdr: standard errors are written as OpenEXR");
    expect_refused("-spp 4 -pXYZ -se e.exr", "the scene's own channels");
    EXPECT_FALSE(folder.has("e.exr"));
}

TEST_F(StandardErrors, of_one_sample_are_the_picture_as_ever) {
    ASSERT_EQ(rpict("-spp 1 -o one.exr").status, 0);
    ASSERT_EQ(rpict("-ps 1 -o ever.exr").status, 0);
    EXPECT_EQ(read_picture(folder.path("one.exr")).pixels, read_picture(folder.path("ever.exr")).pixels);
}

// Under a smooth sky 256 samples in 16 replicas do better than 16 times as many independent ones would: half
// the deviation that 1/sqrt(n) promises, and a third in fact.
TEST_F(StandardErrors, samples_of_a_pixel_are_spread) {
    folder.write("sky.cal", "bright = 1 + Dz * Dz + .5 * Dx;\n");
    folder.write("plate.rad",
                 "void brightfunc varied 2 bright sky.cal 0 0\nvaried glow above 0 0 4 1 1 1 0\n"
                 "above source sky 0 0 4 0 0 1 180\nvoid plastic white 0 0 5 .7 .7 .7 0 0\n"
                 "white polygon plate 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n");
    const auto deviation = [&](int samples) {
        const Outcome result = test::run(
            folder,
            "oconv plate.rad > plate.oct && rpict -w -vp 0 0 5 -vd 0 0 -1 -vu 0 1 0 -x 24 -y 24 -aa 0 -ab 1 "
            "-ad 1 -as 0 -lw 1e-6 -o p.exr -spp " +
                std::to_string(samples) + " plate.oct");
        EXPECT_EQ(result.status, 0) << result.err;
        const Picture picture = read_picture(folder.path("p.exr"));
        double sum = 0, squares = 0;
        for (const float value : picture.pixels) {
            sum += static_cast<double>(value);
            squares += static_cast<double>(value) * static_cast<double>(value);
        }
        const auto count = static_cast<double>(picture.pixels.size());
        return std::sqrt(squares / count - sum * sum / (count * count));
    };
    const double independent = deviation(16) / std::sqrt(256.0 / 16);
    EXPECT_LT(deviation(256), 0.5 * independent);
}

}  // namespace
}  // namespace infra
