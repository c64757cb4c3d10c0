// Frames made by several ranks, which are threads here.
#include <gtest/gtest.h>

#include "../command.h"
#include "rt/programs/distributed/frame_follower.h"
#include "rt/programs/distributed/frame_leader.h"
#include "rt/programs/frame_setup.h"
#include "rt/programs/render_frame.h"
#include "thread_team.h"

namespace infra {
namespace {

constexpr const char* room =
    "void light lum 0 0 3 10 10 10\n"
    "lum sphere lamp 0 0 4 1 6 4 .5\n"
    "lum sphere tiny 0 0 4 -1 6 1 .005\n"  // smaller than the distance of samples
    "void plastic paint 0 0 5 .5 .4 .3 .2 .2\n"
    "paint polygon floor 0 0 12 -9 0 -1  9 0 -1  9 18 -1  -9 18 -1\n"
    "paint sphere ball 0 0 4 0 6 0 1\n";

struct Made {
    Frame frame;
    std::uint64_t rays = 0;
};

struct TeamFrame : testing::Test {
    test::Folder folder;
    RpictOptions options;
    LoadedScene loaded;
    static constexpr int width = 41, height = 30;

    void SetUp() override {
        folder.write("room.rad", room);
        ASSERT_EQ(test::run(folder, "oconv -f room.rad > room.oct").status, 0);
        options.render.settings.ambient_bounces = 1;
        options.render.settings.ambient_accuracy = 0;
        options.render.settings.ambient_divisions = 16;
        options.render.settings.ambient_super_samples = 0;
        options.view.direction = {0, 1, 0};
        set_up_view(options.view);
        loaded = load_scene(folder.path("room.oct"), options.render, no_warnings());
    }

    Frame unknown() const { return empty_frame(width, height, true, options.samples_per_pixel > 1, {}); }

    /// size 0: by this process as ever.
    Made make(int size, int threads, const Frame& known) {
        Made made{known};
        options.threads = threads;
        const FrameOptions frame_size = frame_options(options, width, height, 0, nullptr);
        Camera camera = camera_of(options, options.view, std::nullopt);
        EXPECT_EQ(pass_small_sources(*loaded.scene, options, frame_size, camera).size(), 1U);
        Progress progress("test", width * height, 0, false);
        TracerReport faults;
        const RenderSettings& settings = options.render.settings;
        if (size == 0) {
            Workers workers(threads);
            render_frame(*loaded.scene, settings, camera, frame_size, workers, progress, made.frame, nullptr,
                         faults);
        } else {
            test::run_team(size, [&](Team& team) {
                if (!team.leads()) return follow_frames(team, loaded, options, nullptr);
                Workers workers(threads);
                const PartialFrame unused;
                const std::vector<std::string> lines;
                const WarningSink warn = no_warnings();
                Checkpoint checkpoint("", unused, lines, 0, warn);
                FrameLeader leader(team);
                leader.render(*loaded.scene, settings, camera, frame_size, workers, progress, made.frame,
                              checkpoint, faults);
                EXPECT_TRUE(leader.is_idle());
                leader.dismiss();
            });
            EXPECT_EQ(progress.fraction(), 1);
        }
        made.rays = progress.rays();
        return made;
    }

    void expect_same(const Made& made, const Made& expected) {
        EXPECT_EQ(made.frame.picture.pixels, expected.frame.picture.pixels);
        EXPECT_EQ(made.frame.depth, expected.frame.depth);
        EXPECT_EQ(made.frame.error, expected.frame.error);
        EXPECT_EQ(made.frame.traced, expected.frame.traced);
        EXPECT_EQ(made.rays, expected.rays);  // nothing was traced twice
    }
};

TEST_F(TeamFrame, is_the_same_for_any_number_of_ranks_and_threads) {
    for (const int spacing : {1, 4, 9}) {
        options.sample_spacing = spacing;
        const Made alone = make(0, 1, unknown());
        for (const int ranks : {1, 2, 5})
            for (const int threads : {1, 3}) expect_same(make(ranks, threads, unknown()), alone);
    }
}

TEST_F(TeamFrame, has_the_same_errors_with_several_samples) {
    options.samples_per_pixel = 3;
    expect_same(make(3, 1, unknown()), make(0, 1, unknown()));
}

TEST_F(TeamFrame, goes_on_from_what_is_known) {
    const Made alone = make(0, 1, unknown());
    Frame known = alone.frame;
    for (std::size_t i = 0; i < known.traced.size(); ++i)
        if (i % 3 == 0 || i > known.traced.size() / 2) known.traced[i] = 0;
    const Made rest = make(0, 1, known);
    ASSERT_LT(rest.rays, alone.rays);
    expect_same(make(3, 2, known), rest);
    EXPECT_EQ(rest.frame.picture.pixels, alone.frame.picture.pixels);
}

TEST_F(TeamFrame, that_is_known_is_not_traced_again) {
    const Made alone = make(0, 1, unknown());
    EXPECT_EQ(make(4, 1, alone.frame).rays, 0U);
}

}  // namespace
}  // namespace infra
