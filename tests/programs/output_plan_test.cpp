// Names of rcontrib's outputs, and which value goes where.
#include "rt/programs/rcontrib/output_plan.h"

#include <gtest/gtest.h>

#include "common/error.h"

namespace infra {
namespace {

TEST(OutputName, PutsModifierAndBinInPlace) {
    EXPECT_EQ(output_name("c_%s.dat", "light1", 3).text, "c_light1.dat");
    EXPECT_EQ(output_name("%03d_%s", "a", 7).text, "007_a");
    EXPECT_EQ(output_name("%X-%%", "a", 31).text, "1F-%");
    EXPECT_EQ(output_name("plain", "a", 7).text, "plain");
    EXPECT_TRUE(output_name("%s%d", "a", 7).names_modifier);
    EXPECT_TRUE(output_name("%s%d", "a", 7).names_bin);
    EXPECT_FALSE(output_name("%%s", "a", 7).names_modifier);
    EXPECT_EQ(output_name("%4s", "ab", 7).text, "  ab");
}

TEST(OutputName, RefusesOtherLetters) {
    for (const char* bad : {"%", "%f", "%s%s", "%d%x", "a%l", "%-3d", "%0000009d"})
        EXPECT_THROW(output_name(bad, "a", 0), Error) << bad;
}

RcontribSettings settings_of(std::initializer_list<const char*> outputs) {
    RcontribSettings settings;
    int number = 0;
    for (const char* output : outputs) {
        TrackedModifier& modifier = settings.modifiers.emplace_back();
        modifier.name = "m" + std::to_string(++number);
        if (*output) modifier.output = output;
    }
    return settings;
}

TEST(OutputPlan, JoinsWhatHasOneName) {
    // Two bins of m1, one of m2, two of m3; numbers of spectra in the record 0 1, 2, 3 4.
    const RcontribSettings settings = settings_of({"b%d", "", "b%d"});
    const auto targets = plan_outputs(settings, {{.count = 2}, {}, {.count = 2}}, no_warnings());
    ASSERT_EQ(targets.size(), 3u);
    EXPECT_EQ(targets[0].name, "b0");
    ASSERT_EQ(targets[0].ranges.size(), 2u);
    EXPECT_EQ(targets[0].ranges[0].first, 0u);
    EXPECT_EQ(targets[0].ranges[1].first, 3u);
    EXPECT_EQ(targets[0].size, 2u);
    EXPECT_EQ(targets[1].name, "b1");
    EXPECT_EQ(targets[2].name, "");
}

TEST(OutputPlan, KeepsNeighboursTogether) {
    const auto targets = plan_outputs(settings_of({"", ""}), {{.count = 145}, {}}, no_warnings());
    ASSERT_EQ(targets.size(), 1u);
    ASSERT_EQ(targets[0].ranges.size(), 1u);
    EXPECT_EQ(targets[0].ranges[0].count, 146u);
}

TEST(OutputPlan, CountsOnInPictures) {
    RcontribSettings settings = settings_of({"b%d.hdr", "b%d.hdr"});
    settings.output = NumberFormat::color;
    settings.width = settings.height = 4;
    const auto targets = plan_outputs(settings, {{.count = 2}, {.count = 2}}, no_warnings());
    ASSERT_EQ(targets.size(), 4u);
    EXPECT_EQ(targets[2].name, "b2.hdr");
    EXPECT_EQ(targets[2].modifier, "m2");
    EXPECT_EQ(targets[3].bin, 3);
}

TEST(Parameters, AreNamesAndNumbers) {
    const auto parameters = parse_parameters(" MF=4,rNx = -1; RHS=+1:Ux=.5 b_1=1e-3 ");
    ASSERT_EQ(parameters.size(), 5u);
    EXPECT_EQ(parameters[0].name, "MF");
    EXPECT_EQ(parameters[1].value, -1);
    EXPECT_EQ(parameters[2].value, 1);
    EXPECT_EQ(parameters[3].name, "Ux");
    EXPECT_EQ(parameters[4].value, 1e-3);
    EXPECT_TRUE(parse_parameters("").empty());
    for (const char* bad : {"MF", "MF=", "=3", "4=MF", "a=b", "a=1,,b=2"})
        EXPECT_THROW(parse_parameters(bad), Error) << bad;
}

}  // namespace
}  // namespace infra
