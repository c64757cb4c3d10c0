#include "rt/programs/distributed/message.h"

#include <gtest/gtest.h>

#include "../../common/test_files.h"

namespace infra {
namespace {

using test::error_of;

TEST(Message, is_read_as_it_was_written) {
    MessageWriter out;
    out.put(7);
    out.put_text("ein Wort");
    out.put_all(std::span<const double>(std::vector<double>{1.0 / 3, -0.0}));
    out.put_text("");
    const Bytes bytes = out.take();
    MessageReader in(bytes);
    EXPECT_EQ(in.get<int>(), 7);
    EXPECT_EQ(in.get_text(), "ein Wort");
    EXPECT_EQ(in.get_all<double>(), (std::vector<double>{1.0 / 3, -0.0}));
    EXPECT_FALSE(in.at_end());
    EXPECT_EQ(in.get_text(), "");
    EXPECT_TRUE(in.at_end());
}

TEST(Message, cut_short_is_an_error) {
    MessageWriter out;
    out.put_all(std::span<const float>(std::vector<float>(10)));
    const Bytes bytes = out.take();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::span<const char> part(bytes.data(), size);
        EXPECT_NE(error_of([&] { MessageReader(part).get_all<float>(); }).find("cut short"),
                  std::string::npos);
    }
    // A count that no memory could hold.
    MessageWriter huge;
    huge.put(~std::size_t{0});
    const Bytes claim = huge.take();
    EXPECT_NE(error_of([&] { MessageReader(claim).get_all<float>(); }).find("cut short"), std::string::npos);
}

}  // namespace
}  // namespace infra
