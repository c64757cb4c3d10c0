#include "common/options.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "common/format.h"
#include "test_files.h"

namespace infra {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::write_file;
using Words = std::vector<std::string>;

/// One option of each kind.
struct Fixture {
    double threshold = 0.05;
    float weight = 1e-4f;
    int bounces = 0;
    int x_resolution = 512;
    bool uncorrelated = false;
    bool irradiance = false;
    Vec3 point{0, 0, 0};
    std::array<float, 3> ambient{0, 0, 0};
    std::array<float, 3> extinction{0, 0, 0};
    std::string output;
    std::string values = "v";
    double wavelengths[2] = {0, 0};
    OptionTable table{"rpict", "[octree]"};

    Fixture() {
        table.vec3("-vp", &point, "view point");
        table.integer("-x", &x_resolution, "x resolution").shown([this] {
            return formatted("-x  %-9d", x_resolution);
        });
        table.toggle("-i", &irradiance, "irradiance calculation");
        table.toggle("-u", &uncorrelated, "uncorrelated Monte Carlo sampling",
                     "correlated quasi-Monte Carlo sampling");
        table.real("-dt", &threshold, "direct threshold");
        table.color("-av", &ambient, "ambient value");
        table.integer("-ab", &bounces, "ambient bounces").at_least(0);
        table.color("-me", &extinction, "mist extinction coefficient", true);
        table.real("-lw", &weight, "limit weight", true);
        table.text("-o", &output, "output file").named("file");
        table.attached(
            "-o", "", [this](const OptionValues& given) { values = given.attached; }, "output values");
        table.custom(
            "-cw", "ff",
            [this](const OptionValues& given) {
                wavelengths[0] = given.real(0);
                wavelengths[1] = given.real(1);
                if (wavelengths[0] >= wavelengths[1]) given.reject("the first must be less");
            },
            "wavelength limits");
        table.unsupported("-am", "f", "photon maps are not built yet");
    }
    std::string error(const Words& words) {
        return error_of([&] { table.parse(words); });
    }
};

TEST(Options, EveryKindIsRead) {
    Fixture f;
    const auto rest = f.table.parse({"-vp",  "1",   "-2", "3e1", "-x",    "64",  "-dt",  ".1", "-av",
                                     "1",    "2",   "3",  "-ab", "2",     "-lw", "1e-3", "-o", "p.hdr",
                                     "-ovn", "-cw", "8",  "12",  "a.oct", "-ab", "9"});
    ASSERT_TRUE(rest);
    EXPECT_EQ(*rest, (Words{"a.oct", "-ab", "9"}));
    EXPECT_EQ(f.point, Vec3(1, -2, 30));
    EXPECT_EQ(f.x_resolution, 64);
    EXPECT_EQ(f.threshold, 0.1);
    EXPECT_EQ(f.ambient[2], 3);
    EXPECT_EQ(f.bounces, 2);
    EXPECT_EQ(f.weight, 1e-3f);
    EXPECT_EQ(f.output, "p.hdr");
    EXPECT_EQ(f.values, "vn");
    EXPECT_EQ(f.wavelengths[1], 12);
    EXPECT_EQ(f.table.command_line(),
              "rpict -vp 1 -2 3e1 -x 64 -dt .1 -av 1 2 3 -ab 2 -lw 1e-3 -o p.hdr -ovn -cw 8 12");
}

TEST(Options, BareTogglesInvert) {
    Fixture f;
    f.table.parse({"-u"});
    EXPECT_TRUE(f.uncorrelated);
    f.table.parse({"-u", "-i"});
    EXPECT_FALSE(f.uncorrelated);
    EXPECT_TRUE(f.irradiance);
    for (const auto& [word, state] :
         {std::pair("-u+", true), {"-u-", false}, {"-u1", true}, {"-u0", false}}) {
        f.table.parse({word});
        EXPECT_EQ(f.uncorrelated, state) << word;
    }
}

TEST(Options, LoneDashAndNothingAreOperands) {
    Fixture f;
    EXPECT_EQ(*f.table.parse({"-ab", "1", "-"}), Words{"-"});
    EXPECT_EQ(*f.table.parse(Words{}), Words{});
    char program[] = "rpict", option[] = "-i";
    char* arguments[] = {program, option, nullptr};
    EXPECT_TRUE(f.table.parse(2, arguments)->empty());
    EXPECT_TRUE(f.irradiance);
}

TEST(Options, ErrorsNameTheOption) {
    Fixture f;
    EXPECT_EQ(f.error({"-z"}), "command line error at '-z': unknown option (-help lists the options)");
    EXPECT_EQ(f.error({"-zz"}), "command line error at '-zz': unknown option (-help lists the options)");
    EXPECT_EQ(f.error({"-zzzz"}), "command line error at '-zzzz': unknown option (-help lists the options)");
    EXPECT_EQ(f.error({"-abb", "2"}), "command line error at '-abb': unknown option (did you mean '-ab'?)");
    EXPECT_EQ(f.error({"-defualts"}),
              "command line error at '-defualts': unknown option (did you mean '-defaults'?)");
    EXPECT_EQ(f.error({"-ab", "x"}), "command line error at '-ab x': expected an integer");
    EXPECT_EQ(f.error({"-ab", "1.5"}), "command line error at '-ab 1.5': expected an integer");
    EXPECT_EQ(f.error({"-ab", "-1"}), "command line error at '-ab -1': expected a number of at least 0");
    EXPECT_EQ(f.error({"-dt", "nan"}), "command line error at '-dt nan': expected a number");
    EXPECT_EQ(f.error({"-ab"}), "command line error at '-ab': needs a number (usage: -ab integer)");
    EXPECT_EQ(f.error({"-vp", "1", "2"}), "command line error at '-vp': needs 3 numbers (usage: -vp x y z)");
    EXPECT_EQ(f.error({"-vp", "1", "2", "-ab", "3"}),
              "command line error at '-vp': needs 3 numbers (usage: -vp x y z)");
    EXPECT_EQ(f.error({"-vp", "1", "b", "3"}), "command line error at '-vp b': expected a number");
    EXPECT_EQ(f.error({"-u2"}), "command line error at '-u2': unknown option (did you mean '-u'?)");
    EXPECT_EQ(f.error({"-cw", "12", "8"}), "command line error at '-cw 12 8': the first must be less");
    EXPECT_EQ(f.error({"-am", "3"}),
              "command line error at '-am': option is not supported (photon maps are not built yet)");
}

TEST(Options, FilesAndVariablesAreReadInPlace) {
    const TemporaryFolder folder;
    Fixture f;
    write_file(folder / "opt", "-ab 3 # remark -dt 9\n  -u+\n-x\n77\n");
    setenv("INFRA_TEST_OPTIONS", "-dt .25 @", 1);
    const auto rest = f.table.parse({"-ab", "1", "@" + (folder / "opt"), "-i", "a.oct"});
    EXPECT_EQ(*rest, Words{"a.oct"});
    EXPECT_EQ(f.bounces, 3);
    EXPECT_EQ(f.x_resolution, 77);
    EXPECT_TRUE(f.uncorrelated && f.irradiance);
    EXPECT_EQ(f.table.command_line(), "rpict -ab 1 -ab 3 -u+ -x 77 -i");
    EXPECT_EQ(f.table.command_line_without(std::vector<std::string_view>{"-ab", "-u"}), "rpict -x 77 -i");

    EXPECT_EQ(*f.table.parse({"$INFRA_TEST_OPTIONS", "b.oct"}), (Words{"@", "b.oct"}));
    EXPECT_EQ(f.threshold, 0.25);
    // An argument is taken as it stands.
    f.table.parse({"-o", "$x"});
    EXPECT_EQ(f.output, "$x");

    EXPECT_EQ(f.error({"$INFRA_TEST_NO_SUCH"}),
              "command line error at '$INFRA_TEST_NO_SUCH': there is no such environment variable");
    EXPECT_EQ(f.error({"@" + (folder / "none")}),
              "cannot read \"" + (folder / "none") + "\": No such file or directory");
    write_file(folder / "circle", "@" + (folder / "circle"));
    EXPECT_EQ(f.error({"@" + (folder / "circle")}),
              "command line error at '@" + (folder / "circle") + "': refers to itself");
}

TEST(Options, EnvironmentComesFirst) {
    Fixture f;
    f.table.read_environment("INFRA_TEST_RENDER");
    unsetenv("INFRA_TEST_RENDER");
    EXPECT_TRUE(f.table.parse(Words{}));
    setenv("INFRA_TEST_RENDER", "-ab 5 -dt .5", 1);
    f.table.parse({"-ab", "2"});
    EXPECT_EQ(f.bounces, 2);
    EXPECT_EQ(f.threshold, 0.5);
    unsetenv("INFRA_TEST_RENDER");
}

// Tabs and widths as RADIANCE 6.1's "rpict -defaults" prints them.
TEST(Options, DefaultsShowTheValuesSoFar) {
    Fixture f;
    testing::internal::CaptureStdout();
    EXPECT_FALSE(f.table.parse({"-ab", "2", "-u+", "-defaults", "-ab", "x"}));
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "-vp 0.000000 0.000000 0.000000\t# view point\n"
              "-x  512      \t\t\t# x resolution\n"
              "-i-\t\t\t\t# irradiance calculation off\n"
              "-u+\t\t\t\t# uncorrelated Monte Carlo sampling\n"
              "-dt 0.050000\t\t\t# direct threshold\n"
              "-av 0.000000 0.000000 0.000000\t# ambient value\n"
              "-ab 2        \t\t\t# ambient bounces\n"
              "-me 0.00e+00 0.00e+00 0.00e+00\t# mist extinction coefficient\n"
              "-lw 1.00e-04\t\t\t# limit weight\n");
}

TEST(Options, DefaultsCanBeReadBack) {
    const TemporaryFolder folder;
    Fixture f, g;
    f.table.parse({"-ab", "2", "-u+", "-av", ".5", "1", "2"});
    write_file(folder / "opt", f.table.defaults());
    EXPECT_TRUE(g.table.parse({"@" + (folder / "opt")})->empty());
    EXPECT_EQ(f.table.defaults(), g.table.defaults());
}

TEST(Options, HelpListsEveryRow) {
    Fixture f;
    const std::string help = f.table.help();
    for (const OptionRow& row : f.table.rows())
        EXPECT_NE(help.find(row.spelling), std::string::npos) << row.spelling;
    EXPECT_NE(help.find("usage: rpict [options] [octree]\n"), std::string::npos);
    EXPECT_NE(help.find("  -ab integer               ambient bounces [-ab 0]\n"), std::string::npos) << help;
    EXPECT_NE(help.find("  -u[+|-]                   uncorrelated"), std::string::npos) << help;
    EXPECT_NE(help.find("not supported yet:\n  -am  "), std::string::npos) << help;
    testing::internal::CaptureStdout();
    EXPECT_FALSE(f.table.parse({"-help"}));
    EXPECT_FALSE(f.table.parse({"-version"}));
    EXPECT_EQ(testing::internal::GetCapturedStdout().find(help + "Infradiance "), 0u);
}

TEST(Options, ANegativeNumberIsAValue) {
    Fixture f;
    EXPECT_EQ(f.table.parse(Words{"-ab", "1", "-40", "-.5"}), (Words{"-40", "-.5"}));
    EXPECT_EQ(f.table.parse(Words{"-1e3"}), (Words{"-1e3"}));
    EXPECT_NE(f.error({"-1x"}).find("unknown option"), std::string::npos);
}

TEST(Options, HelpHoldsTheDescription) {
    Fixture f;
    f.table.describe("Renders scenes.");
    EXPECT_NE(f.table.help().find("usage: rpict [options] [octree]\n\nRenders scenes.\n\n  -vp"),
              std::string::npos);
}

TEST(OptionTable, AnOptionMayTakeTheRestOfTheCommandLine) {
    OptionTable table("test");
    table.take_words_literally();
    std::vector<std::string> rest;
    bool plus = false;
    table.rest(
        "-c", 1, [&](const OptionValues& given) { rest.assign(given.values.begin(), given.values.end()); },
        "command");
    table.custom(
        "+d", "", [&](const OptionValues&) { plus = true; }, "dimensions");
    const auto operands = table.parse({"+d", "-c", "run", "-x", "@file", "$NAME"});
    EXPECT_TRUE(operands && operands->empty());
    EXPECT_TRUE(plus);
    EXPECT_EQ(rest, (std::vector<std::string>{"run", "-x", "@file", "$NAME"}));
    EXPECT_EQ(table.parse({"@file", "-c"}), (std::vector<std::string>{"@file", "-c"}));
    EXPECT_THROW(table.parse({"-c"}), Error);
}

}  // namespace
}  // namespace infra
