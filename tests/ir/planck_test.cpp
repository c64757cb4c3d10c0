// planck as its users run it.
#include <gtest/gtest.h>

#include <utility>

#include "programs/command.h"

namespace infra::ir {
namespace {

using test::Folder;
using test::Outcome;
using test::run;

std::string output_of(const std::string& command) {
    const Folder folder;
    folder.write("r.txt", "8 1\n12 1\n");
    folder.write("t.txt", "# id T\na 250 x\nb\t300 y\n\nc 350 z\n");
    const Outcome outcome = run(folder, command);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
}

TEST(PlanckProgram, ConvertsValues) {
    EXPECT_EQ(output_of("planck -b 8 12 250 300 350"), "14.559301\n38.5004239\n78.0355418\n");
    EXPECT_EQ(output_of("planck -b 3 5 300"), "1.86595621\n");
    EXPECT_EQ(output_of("planck -r r.txt 300"), "38.5004239\n");
    EXPECT_EQ(output_of("planck -b 8 12 -C 15 20 25"), "31.4780243\n34.3343707\n37.3462597\n");
    EXPECT_EQ(output_of("planck -b 8 12 -C -40"), output_of("planck -b 8 12 233.15"));
    EXPECT_EQ(output_of("planck -b 8 12 -i 38.5004239333"), "300\n");
    EXPECT_EQ(output_of("planck -b 8 12 -d 300"), "0.629704347\n");
}

TEST(PlanckProgram, ConvertsAColumnOfTheStandardInput) {
    EXPECT_EQ(output_of("planck -b 8 12 -c 2 < t.txt"),
              "# id T\na 14.559301 x\nb\t38.5004239 y\n\nc 78.0355418 z\n");
    EXPECT_EQ(output_of("planck -b 8 12 -c 2 < t.txt | planck -b 8 12 -i -C -c 2 | tail -1"), "c 76.85 z\n");
    EXPECT_EQ(output_of("planck -b 8 12 < /dev/null"), "");
}

TEST(PlanckProgram, ExplainsItself) {
    const std::string help = output_of("planck -help");
    for (const char* text : {"usage: planck [options] [value ...]", "-b lo hi", "-r response.txt", "-i ",
                             "-d ", "-C ", "-c column", "planck -b 8 12 300 "})
        EXPECT_NE(help.find(text), std::string::npos) << text;
}

TEST(PlanckProgram, RefusesInOneLine) {
    const Folder folder;
    folder.write("t.txt", "250\n300\nx\n");
    folder.write("cold.txt", "250\n-300\n");
    folder.write("bad.txt", "8 1\n8 2\n");
    const std::pair<const char*, const char*> cases[] = {
        {"300", "no band (-b 8 12 gives one in um, -r file a spectral response)"},
        {"-b 12 8 300",
         "band 12..8 um is empty or reversed (give the shorter wavelength first, in micrometres)"},
        {"-b 8000 12000 300",
         "band 8000..12000 um is not within 0.2..1000 um (wavelengths are in micrometres)"},
        {"-b 8 nan 300", "command line error at '-b nan': expected a number"},
        {"-b 8 12 0", "temperature 0 K is not above absolute zero"},
        {"-b 8 12 -C -274", "temperature -274 degrees C is not above -273.15 degrees C"},
        {"-b 8 12 nan", "\"nan\" is not a number (values come after the options)"},
        {"-b 8 12 300 -i", "\"-i\" is not a number (values come after the options)"},
        {"-b 8 12 -i 0", "radiance 0 has no temperature (it must be a positive number)"},
        {"-b 8 12 -i -d 5", "command line error at '-d': -i and -d exclude one another"},
        {"-b 8 12 -b 3 5 300",
         "command line error at '-b 3 5': there is a band or response already (give -b or -r, once)"},
        {"-b 8 12 -c 2 300", "-c is for the standard input (leave out -c or the values)"},
        {"-b 8 12 -c 0", "command line error at '-c 0': expected a number of at least 1"},
        {"-r none.txt 300", "cannot read \"none.txt\": No such file or directory"},
        {"-r bad.txt 300", "bad.txt:2: wavelength 8 um does not come after 8 um"},
        {"-b 8 12 < t.txt", "standard input:3: \"x\" is not a number"},
        {"-b 8 12 < cold.txt", "standard input:2: temperature -300 K is not above absolute zero"},
        {"-b 8 12 -c 2 < t.txt", "standard input:1: there is no column 2"},
    };
    for (const auto& [arguments, expected] : cases) {
        const Outcome outcome = run(folder, std::string("planck ") + arguments);
        EXPECT_EQ(outcome.err, "planck: " + std::string(expected) + "\n") << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(outcome.status, 1) << arguments;
    }
    EXPECT_EQ(run(folder, "planck -b 8 12 300 > /dev/full").status, 2);
}

}  // namespace
}  // namespace infra::ir
