#include "rt/programs/distributed/traced_pixels.h"

#include <gtest/gtest.h>

#include "../../common/test_files.h"

namespace infra {
namespace {

Frame frame_of(int width, int height, bool with_all) {
    Frame frame;
    frame.picture = {.width = width, .height = height, .channels = 4, .space = ColorSpace::spectrum};
    const std::size_t pixels = std::size_t(width) * height;
    frame.picture.pixels.resize(4 * pixels);
    if (with_all) frame.depth.resize(pixels), frame.error.resize(4 * pixels);
    frame.traced.resize(pixels);
    return frame;
}

/// Values that are no round numbers.
void trace(Frame& frame, std::size_t pixel) {
    for (std::size_t c = 0; c < 4; ++c) {
        frame.picture.pixels[4 * pixel + c] = 1 / float(7 * pixel + c + 1);
        if (!frame.error.empty()) frame.error[4 * pixel + c] = 1 / float(11 * pixel + c + 1);
    }
    if (!frame.depth.empty()) frame.depth[pixel] = float(pixel) / 3;
    frame.mark_traced(pixel);
}

TEST(TracedPixels, come_over_exactly_and_alone) {
    for (const bool with_all : {false, true}) {
        Frame sent = frame_of(6, 5, with_all);
        const std::vector<std::uint64_t> numbers{3, 4, 5, 9, 29};
        for (const std::uint64_t number : numbers) trace(sent, number);
        EXPECT_EQ(traced_pixels(sent), numbers);
        sent.picture.pixels[0] = 17;  // interpolated
        MessageWriter out;
        put_pixels(out, sent, numbers);
        const Bytes bytes = out.take();
        Frame received = frame_of(6, 5, with_all);
        MessageReader in(bytes);
        EXPECT_EQ(take_pixels(in, received), numbers);
        EXPECT_TRUE(in.at_end());
        sent.picture.pixels[0] = 0;
        EXPECT_EQ(received.picture.pixels, sent.picture.pixels);
        EXPECT_EQ(received.depth, sent.depth);
        EXPECT_EQ(received.error, sent.error);
        EXPECT_EQ(received.traced, sent.traced);
    }
}

TEST(TracedPixels, of_another_frame_are_refused) {
    Frame sent = frame_of(6, 5, false);
    const std::vector<std::uint64_t> numbers{29};
    MessageWriter out;
    put_pixels(out, sent, numbers);
    const Bytes bytes = out.take();
    Frame small = frame_of(6, 4, false), with_all = frame_of(6, 5, true);
    MessageReader first(bytes), second(bytes);
    EXPECT_NE(test::error_of([&] { take_pixels(first, small); }).find("not in the picture"),
              std::string::npos);
    EXPECT_NE(test::error_of([&] { take_pixels(second, with_all); }).find("another kind"), std::string::npos);
}

}  // namespace
}  // namespace infra
