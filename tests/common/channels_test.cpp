#include "common/spectra/channels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/error.h"

namespace infra {
namespace {

TEST(Channels, RunFromTheLongestWavelength) {
    const Channels channels = Channels::spectral(8, 8000, 12000);
    EXPECT_FALSE(channels.is_rgb());
    EXPECT_EQ(channels.count(), 8);
    EXPECT_DOUBLE_EQ(channels.upper_nm(0), 12000);
    EXPECT_DOUBLE_EQ(channels.lower_nm(0), 11500);
    EXPECT_DOUBLE_EQ(channels.center_nm(7), 8250);
    EXPECT_EQ(channels, Channels::spectral(8, 12000, 8000));
    EXPECT_EQ(channels.description(), "8 channels of 8000-12000 nm");
    EXPECT_TRUE(Channels().is_rgb());
}

/// Which third of an RGB triple each channel gets, as RADIANCE 6.1's rtrace -co+ shows it.
std::string primaries(const Channels& channels) {
    std::string text;
    for (int c = 0; c < channels.count(); ++c) text += "rgb"[channels.primary_of(c)];
    return text;
}

TEST(Channels, TakeTheColorOfTheirMiddle) {
    EXPECT_EQ(primaries(Channels()), "rgb");
    EXPECT_EQ(primaries(Channels::spectral(20, 380, 780)), "rrrrrrrrrrgggggbbbbb");
    EXPECT_EQ(primaries(Channels::spectral(4, 8000, 12000)), "rggb");
    EXPECT_EQ(primaries(Channels::spectral(7, 8000, 12000)), "rrgggbb");
    EXPECT_EQ(primaries(Channels::spectral(8, 8000, 12000)), "rrrggbbb");
}

TEST(Channels, KnowWhetherTheyShowColors) {
    EXPECT_TRUE(Channels::spectral(8, 400, 2500).shows_colors());
    EXPECT_FALSE(Channels::spectral(8, 500, 2500).shows_colors());
    EXPECT_FALSE(Channels::spectral(8, 300, 600).shows_colors());
}

TEST(Channels, RefuseWhatIsNoRange) {
    EXPECT_THROW(Channels::spectral(2, 380, 780), Error);
    EXPECT_THROW(Channels::spectral(25, 380, 780), Error);
    EXPECT_THROW(Channels::spectral(8, 500, 500), Error);
    EXPECT_THROW(Channels::spectral(8, -1, 500), Error);
    EXPECT_THROW(Channels::spectral(8, std::nan(""), 500), Error);
}

}  // namespace
}  // namespace infra
