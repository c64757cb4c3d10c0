#include "rt/programs/partial_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "command.h"

namespace infra {
namespace {

using test::error_of;

const Channels four_bands = Channels::spectral(4, 8000, 12000);

/// Every third pixel of 5 x 4 is known, in 4 channels and depth, below one row of colors.
PartialFrame example() {
    PartialFrame partial;
    partial.view.direction = {1.0 / 3, 2, 0.1};
    set_up_view(partial.view);
    partial.width = 5;
    partial.height = 4;
    partial.pixel_aspect = 1.25;
    partial.finished_rows = {.width = 5, .height = 1, .channels = 3};
    partial.finished_rows.pixels.assign(15, 0.75f);
    Frame& frame = partial.frame;
    frame.picture = {.width = 5, .height = 4, .channels = 4, .space = ColorSpace::spectrum};
    frame.picture.pixels.resize(20 * 4);
    frame.depth.resize(20);
    frame.error.resize(20 * 4);
    frame.traced.resize(20);
    for (std::size_t i = 5; i < 20; i += 3) {
        frame.traced[i] = 1;
        frame.depth[i] = float(i) / 3;
        for (std::size_t c = 0; c < 4; ++c)
            frame.picture.pixels[4 * i + c] = 1 / float(i + c), frame.error[4 * i + c] = 1 / float(i + c + 1);
    }
    return partial;
}

TEST(PartialFrame, comes_back_to_the_last_bit) {
    const test::Folder folder;
    PartialFrame written = example();
    write_partial(folder.path("p"), written, {"rpict -x 5", "SOFTWARE= x"});
    EXPECT_TRUE(is_partial(folder.path("p")));
    EXPECT_EQ(partial_fingerprint(folder.path("p")), "");
    written.fingerprint = "0123";
    write_partial(folder.path("p"), written, {"rpict -x 5", "SOFTWARE= x"});
    EXPECT_EQ(partial_fingerprint(folder.path("p")), "0123");
    const PartialFrame read = read_partial(folder.path("p"), four_bands);
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 4);
    EXPECT_EQ(read.pixel_aspect, 1.25);
    EXPECT_EQ(read.view.direction.x, written.view.direction.x);
    EXPECT_EQ(read.view.distance, written.view.distance);
    EXPECT_EQ(read.view.image_y.z, written.view.image_y.z);
    EXPECT_EQ(read.view.image_height, written.view.image_height);
    EXPECT_EQ(read.finished_rows.pixels, written.finished_rows.pixels);
    EXPECT_EQ(read.frame.picture.pixels, written.frame.picture.pixels);
    EXPECT_EQ(read.frame.depth, written.frame.depth);
    EXPECT_EQ(read.frame.error, written.frame.error);
    EXPECT_EQ(read.frame.traced, written.frame.traced);
    EXPECT_EQ(read.frame.picture.space, ColorSpace::spectrum);
}

TEST(PartialFrame, is_no_picture_for_others) {
    const test::Folder folder;
    write_partial(folder.path("p.hdr"), example(), {});
    EXPECT_NE(error_of([&] { read_picture(folder.path("p.hdr")); }).find("unknown picture format"),
              std::string::npos);
    folder.write("q", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n");
    EXPECT_FALSE(is_partial(folder.path("q")));
    EXPECT_NE(error_of([&] { read_partial(folder.path("q"), four_bands); }), "no error");
    EXPECT_NE(error_of([&] { read_partial(folder.path("none"), four_bands); }), "no error");
}

/// The error for a file whose first bytes of this value are replaced.
template <class Value>
std::string error_with(const PartialFrame& partial, Value written, Value replaced) {
    const test::Folder folder;
    write_partial(folder.path("p"), partial, {});
    std::string bytes = folder.read("p");
    const std::size_t values = bytes.find('\n', bytes.find("-Y ")) + 1;
    const std::string_view wanted(reinterpret_cast<const char*>(&written), sizeof written);
    const std::size_t at = bytes.find(wanted, values);
    EXPECT_NE(at, std::string::npos);
    bytes.replace(at, sizeof replaced, reinterpret_cast<const char*>(&replaced), sizeof replaced);
    folder.write("p", bytes);
    return error_of([&] { read_partial(folder.path("p"), four_bands); });
}

TEST(PartialFrame, is_refused_without_rays) {
    const PartialFrame partial = example();
    const View& view = partial.view;
    for (const double number : {view.image_width, view.image_height})
        EXPECT_NE(error_with(partial, number, 0.0).find("no view in it"), std::string::npos);
    for (const Vec3& vector : {view.direction, view.image_x, view.image_y})
        EXPECT_NE(error_with(partial, vector, Vec3{0, 0, 0}).find("no view in it"), std::string::npos);
    EXPECT_EQ(error_with(partial, view.direction, view.direction), "no error");
}

TEST(PartialFrame, asks_for_no_more_memory_than_its_picture_needs) {
    struct Sizes {
        int width, height, channels;
    };
    const Sizes sizes{5, 4, 4};
    EXPECT_NE(error_with(example(), sizes, Sizes{5, 4, 4096}).find("-cs, -cw"), std::string::npos);
    constexpr int spectrum = static_cast<int>(ColorSpace::spectrum), rgb = static_cast<int>(ColorSpace::rgb);
    struct Kind {
        int channels, space;
    };
    EXPECT_NE(error_with(example(), Kind{4, spectrum}, Kind{4, rgb}).find("-cs, -cw"), std::string::npos);
    // All of a large picture traced, and no values.
    PartialFrame large;
    large.view = example().view;
    large.width = large.height = 1000;
    large.frame.picture = {.width = 1000, .height = 1000, .channels = 24, .space = ColorSpace::spectrum};
    const test::Folder folder;
    write_partial(folder.path("p"), large, {});
    folder.write("p", folder.read("p") + std::string(1'000'000, 1));
    EXPECT_NE(error_of([&] {
                  read_partial(folder.path("p"), Channels::spectral(24, 8000, 9000));
              }).find("cut short"),
              std::string::npos);
}

TEST(PartialFrame, is_refused_when_damaged) {
    const test::Folder folder;
    const std::string path = folder.path("p");
    write_partial(path, example(), {});
    const std::string whole = folder.read("p");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        folder.write("p", whole.substr(0, size));
        EXPECT_NE(error_of([&] { read_partial(path, four_bands); }), "no error") << size;
    }
    folder.write("p", whole + "x");
    EXPECT_NE(error_of([&] { read_partial(path, four_bands); }), "no error");
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {  // no crash, whatever comes of it
        std::string bytes = whole;
        bytes[random() % bytes.size()] = char(random());
        folder.write("p", bytes);
        error_of([&] { read_partial(path, four_bands); });
    }
}

}  // namespace
}  // namespace infra
