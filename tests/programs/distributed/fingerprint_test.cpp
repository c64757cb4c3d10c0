#include "rt/programs/distributed/fingerprint.h"

#include <gtest/gtest.h>

#include "../command.h"
#include "scene/warnings.h"

namespace infra {
namespace {

TEST(Fingerprint, tells_texts_apart) {
    const auto of = [](std::initializer_list<std::string_view> texts) {
        Fingerprint fingerprint;
        for (const std::string_view text : texts) fingerprint.add_text(text);
        return fingerprint.text();
    };
    EXPECT_EQ(of({"a", "b"}), of({"a", "b"}));
    EXPECT_NE(of({"a", "b"}), of({"b", "a"}));
    EXPECT_NE(of({"ab"}), of({"a", "b"}));
    EXPECT_NE(of({"a"}), of({std::string_view("a\0", 2)}));
    EXPECT_EQ(of({"a"}).size(), 16U);
}

TEST(Fingerprint, tells_views_apart_to_the_last_bit) {
    View view;
    view.direction = {0, 1, 0};
    set_up_view(view);
    Fingerprint one, other;
    one.add_view(view);
    view.point.x = std::nextafter(view.point.x, 1.0);
    other.add_view(view);
    EXPECT_NE(one.value(), other.value());
}

struct FingerprintOfScene : testing::Test {
    test::Folder folder;

    void SetUp() override {
        folder.write("room.rad", "void brightfunc stripes 2 stripe " + folder.path("stripe.cal") +
                                     " 0 0\nstripes plastic paint 0 0 5 .5 .4 .3 0 0\n"
                                     "paint sphere ball 0 0 4 0 6 0 1\n");
        folder.write("stripe.cal", "stripe = if(Px, 1, .5);\n");
        folder.write("near.cal", "near = 1;\n");
        ASSERT_EQ(test::run(folder, "oconv -f room.rad > room.oct").status, 0);
    }
    std::string of(const std::string& command = "rpict -ab 1", std::vector<std::string> words = {}) {
        const LoadedScene loaded = load_scene(folder.path("room.oct"), rpict_defaults(), no_warnings());
        words.push_back(folder.path("room.oct"));
        return fingerprint_of(loaded, command, words).text();
    }
};

TEST_F(FingerprintOfScene, changes_with_all_that_a_picture_depends_on) {
    const std::string first = of();
    EXPECT_EQ(of(), first);
    EXPECT_NE(of("rpict -ab 2"), first);
    folder.write("stripe.cal", "stripe = if(Px, 1, .6);\n");  // which the octree only names
    const std::string second = of();
    EXPECT_NE(second, first);
    const std::string with_file = of("rpict -ab 1", {"-f", folder.path("near.cal")});
    EXPECT_NE(with_file, second);
    folder.write("near.cal", "near = 2;\n");
    EXPECT_NE(of("rpict -ab 1", {"-f", folder.path("near.cal")}), with_file);
    EXPECT_EQ(of(), second);
    folder.write("room.rad", "void plastic paint 0 0 5 .5 .4 .3 0 0\npaint sphere ball 0 0 4 0 6 0 1.1\n");
    ASSERT_EQ(test::run(folder, "oconv -f room.rad > room.oct").status, 0);
    EXPECT_NE(of(), second);
}

TEST_F(FingerprintOfScene, changes_with_scene_files_that_the_octree_names) {
    const std::string rad = folder.path("room.rad");
    ASSERT_EQ(test::run(folder, "oconv " + rad + " > room.oct").status, 0);
    const std::string first = of();
    folder.write("room.rad", folder.read("room.rad") + "# a remark\n");
    EXPECT_NE(of(), first);
}

}  // namespace
}  // namespace infra
