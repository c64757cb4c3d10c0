#include "ir/brdftab/lobe_plot.h"

#include <gtest/gtest.h>

#include "ir/brdftab/radial_scale.h"
#include "samples.h"

namespace infra::ir {
namespace {

using test::degree;

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

TEST(DrawLobes, ShowsTwoCurvesAPanelAndEverySampleAsAStar) {
    const BrdfFunction f = gaussian_lobe(0.1, 0.3, 0.15);
    const std::vector<BrdfSample> samples = test::measure_cuts(f, {20, 40, 60}, 10);
    const LobePlot plot{"paint <A & B>", measured_incident_angles(samples), false};
    ASSERT_EQ(plot.incident_angles.size(), 3u);
    const std::string svg = draw_lobes(BrdfTable(tabulate(f)), samples, plot);
    EXPECT_EQ(count(svg, "stroke-width=\"1.9\""), 3u * 2 + 2);      // curves, and the legend's
    EXPECT_EQ(count(svg, "stroke=\"white\""), samples.size() + 2);  // and two in the legend
    EXPECT_NE(svg.find("paint &lt;A &amp; B>"), std::string::npos);
    EXPECT_EQ(svg, draw_lobes(BrdfTable(tabulate(f)), samples, plot));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawLobes, DrawsABlackSurface) {
    for (const bool logarithmic : {false, true}) {
        const std::string svg =
            draw_lobes(BrdfTable(tabulate(lambertian(0))), {}, {"black", {0.5}, logarithmic});
        EXPECT_EQ(svg.find("nan"), std::string::npos);
        EXPECT_EQ(svg.find("inf"), std::string::npos);
    }
}

TEST(RadialScale, HasRoundRings) {
    const RadialScale linear(0.1, 1, false);
    EXPECT_EQ(linear.ticks(), (std::vector<double>{0.5, 1}));
    EXPECT_EQ(linear.share(0), 0);
    const RadialScale decades(0.03, 1, true);
    ASSERT_EQ(decades.ticks().size(), 2u);
    EXPECT_DOUBLE_EQ(decades.ticks()[0], 0.1);
    EXPECT_LT(decades.share(1), 1);
    EXPECT_EQ(decades.share(0), 0);
}

TEST(MeasuredIncidentAngles, AreFewAndAscending) {
    const BrdfFunction f = lambertian(0.5);
    const auto angles =
        measured_incident_angles(test::measure_cuts(f, {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 60}, 40));
    ASSERT_EQ(angles.size(), 6u);
    EXPECT_NEAR(angles.front(), 0, 1e-12);
    EXPECT_NEAR(angles.back(), 60 * degree, 1e-12);
}

}  // namespace
}  // namespace infra::ir
