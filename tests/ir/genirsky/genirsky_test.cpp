// genirsky as its users run it: what it writes, rendered by rtrace, and what it refuses.
#include <gtest/gtest.h>

#include <sstream>

#include "common/planck/planck.h"
#include "fixtures.h"
#include "ir/genirsky/frame.h"
#include "programs/command.h"

namespace infra::ir {
namespace {

using infra::test::Folder;
using infra::test::Outcome;
using infra::test::run;
using test::GreyAir;

struct Genirsky : testing::Test {
    Folder folder;

    /// Runs genirsky and makes scene.oct of what it writes.
    void make(const std::string& arguments) {
        const Outcome made =
            run(folder, "genirsky " + arguments + " -o made.rad && oconv made.rad > scene.oct");
        ASSERT_EQ(made.status, 0) << made.err;
    }

    /// What rtrace sees in these directions, all channels of each.
    std::vector<std::vector<double>> seen(const std::vector<Vec3>& directions,
                                          const std::string& options = {}) {
        std::string rays;
        for (const Vec3& d : directions) rays += formatted("1 2 3 %.15g %.15g %.15g\n", d.x, d.y, d.z);
        folder.write("rays", rays);
        const Outcome traced = run(folder, "rtrace -h " + options + " scene.oct < rays");
        EXPECT_EQ(traced.status, 0) << traced.err;
        std::vector<std::vector<double>> values;
        std::istringstream lines(traced.out);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            values.emplace_back();
            for (double value = 0; words >> value;) values.back().push_back(value);
        }
        EXPECT_EQ(values.size(), directions.size());
        return values;
    }

    /// Error text of a command that must fail and leave nothing.
    std::string error(const std::string& arguments) {
        const Outcome outcome = run(folder, "genirsky " + arguments);
        EXPECT_EQ(outcome.status, 1) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        return outcome.err;
    }
};

double node(int column, int row) { return row == 0 ? 25 : 10 + (column % 20 * 37 + row * 13) % 19; }

std::string node_table() {
    std::string text;
    for (int column = 0; column <= 20; ++column)
        for (int row = 0; row < 10; ++row)
            text += formatted("%g%c", node(column, row), row == 9 ? '\n' : ' ');
    return text;
}

constexpr double single_precision = 1e-5;  // of values up to 40

TEST_F(Genirsky, SkyByElevationReturnsItsTable) {
    folder.write("sky.txt", "12.1 12.2 12.6 13.3 14.4 16.0 18.4 21.9 27.0 31.5\n");
    const std::vector<double> ten{12.1, 12.2, 12.6, 13.3, 14.4, 16.0, 18.4, 21.9, 27.0, 31.5};
    for (const bool y_up : {false, true}) {
        make(std::string("sky -elev sky.txt -L -b 8 12") + (y_up ? " -yup" : ""));
        std::vector<Vec3> directions;
        for (int n = 0; n < 36; ++n)
            directions.push_back(Frame{.y_up = y_up}.direction(90 - 2.5 * n, 47 * n));
        const auto values = seen(directions);
        for (std::size_t n = 0; n < 36; ++n) {
            const double part = 0.25 * static_cast<double>(n % 4), low = ten[n / 4], high = ten[n / 4 + 1];
            EXPECT_NEAR(values[n][1], low + part * (high - low), single_precision) << n;
        }
    }
}

/// Directions of all nodes above the horizon (below it for up = -1), and of places between them.
std::vector<Vec3> node_directions(const Frame& frame, double up) {
    std::vector<Vec3> directions;
    for (int column = 0; column < 20; ++column)
        for (int row = 0; row < 9; ++row) {
            directions.push_back(frame.direction(up * (90 - 10 * row), 18 * column));
            directions.push_back(frame.direction(up * (85 - 10 * row), 18 * column + 4.5));
        }
    return directions;
}

TEST_F(Genirsky, TablesReturnTheirNodesInEveryFrame) {
    folder.write("table.txt", node_table());
    for (const auto& [subject, frame] : {std::pair<std::string, Frame>{"sky", {false, 40}},
                                         {"sky", {true, 0}},
                                         {"sea", {true, 40}},
                                         {"sea", {}}}) {
        make(subject + " -table table.txt -L" + (frame.y_up ? " -yup" : "") +
             formatted(" -turn %g", frame.turn_deg));
        const auto values = seen(node_directions(frame, subject == "sky" ? 1 : -1));
        std::size_t n = 0;
        for (int column = 0; column < 20; ++column)
            for (int row = 0; row < 9; ++row) {
                EXPECT_NEAR(values[n++][0], node(column, row), single_precision) << subject << column << row;
                const double here = node(column, row) + node(column, row + 1);
                const double next = node(column + 1, row) + node(column + 1, row + 1);
                EXPECT_NEAR(values[n++][0], .5 * (.75 * here + .25 * next), single_precision);
            }
    }
}

TEST_F(Genirsky, SkyOfTape7IsTheClosedForm) {
    std::string text;
    for (const int angle : {0, 30, 60, 80})
        text += test::tape7_run({.transmittance = std::exp(-.3 / std::cos(angle * std::numbers::pi / 180))});
    folder.write("up.tp7", text);
    make("sky -tape7 up.tp7 -angles 0,30,60,80 -b 8 12");
    const auto values = seen({{0, 0, 1}, Frame{}.direction(60, 10), Frame{}.direction(30, 10)});
    const double black = band_radiance(288.15, 8, 12);
    EXPECT_NEAR(values[0][0], (1 - std::exp(-.3)) * black, 1e-5 * black);
    EXPECT_NEAR(values[1][0], (1 - std::exp(-.3 / std::cos(std::numbers::pi / 6))) * black, 1e-5 * black);
    EXPECT_NEAR(values[2][0], (1 - std::exp(-.6)) * black, 1e-5 * black);
}

TEST_F(Genirsky, ChannelsShowTheirBands) {
    struct Case {
        std::string command;
        int channels;
        double altitude, azimuth;  ///< where to look, degrees
        double kelvin;             ///< there
    };
    folder.write("sky.txt", "250 251 252 253 254 255 256 257 258 290\n");
    folder.write("sea.txt", "290 291 292 293 294 295 296 297 298 299\n");
    folder.write("table.txt", node_table());
    for (const Case& c : {Case{"sky -elev sky.txt -K", 3, 50, 77, 254},
                          {"sea -elev sea.txt -K", 24, -50, 77, 294},
                          {"sky -table table.txt -C", 8, 40, 126, 273.15 + node(7, 5)}}) {
        const std::string channels = formatted(" -cs %d -cw 8000 12000", c.channels);
        make(c.command + channels);
        const auto values = seen({Frame{}.direction(c.altitude, c.azimuth)}, "-co+" + channels)[0];
        ASSERT_EQ(values.size(), static_cast<std::size_t>(c.channels));
        for (int n = 0; n < c.channels; ++n) {
            const double step = 4. / c.channels;
            const double expected = c.channels * band_radiance(c.kelvin, 12 - (n + 1) * step, 12 - n * step);
            EXPECT_NEAR(values[static_cast<std::size_t>(n)], expected, 3e-6 * expected) << c.command << n;
        }
    }
}

TEST_F(Genirsky, SunGivesItsIrradiance) {  // VALIDATION V14
    const std::string plate = "void plastic half 0 0 5 .5 .5 .5 0 0\nhalf ring plate 0 0 8 0 0 0 0 0 1 0 9\n";
    struct Case {
        std::string band;
        double irradiance;
    };
    for (const Case& band : {Case{"3 5", 21.842}, Case{"8 12", 1.2995}}) {
        folder.write("plate.rad", plate);
        const Outcome made = run(folder, "genirsky sun -ang 90 0 -b " + band.band +
                                             " -o sun.rad && oconv plate.rad sun.rad > scene.oct && "
                                             "echo 0 0 1 0 0 -1 | rtrace -h -dj 0 scene.oct");
        ASSERT_EQ(made.status, 0) << made.err;
        EXPECT_NEAR(std::stod(made.out) * 2 * std::numbers::pi, band.irradiance, 1e-3 * band.irradiance);
    }
}

TEST_F(Genirsky, SunStandsWhereItIsToldAndDimmed) {
    folder.write("path.tp7", test::tape7_transmittance_run(.5));
    make("sun -ang 35 120 -turn 90 -trans .5 -tape7 path.tp7 -b 3 5 -half-angle 1");
    const double radiance = .25 * band_radiance(5772, 3, 5);
    const Frame frame{.turn_deg = 90};
    const auto values =
        seen({frame.direction(35, 120), frame.direction(35.9, 120), frame.direction(36.1, 120)});
    EXPECT_NEAR(values[0][0], radiance, 1e-5 * radiance);
    EXPECT_NEAR(values[1][0], radiance, 1e-5 * radiance);
    EXPECT_EQ(values[2][0], 0);
    make("sun -dir 0 1 1 -cs 4 -cw 3000 5000");
    const auto channels = seen({{0, 1, 1}}, "-co+ -cs 4 -cw 3000 5000");
    ASSERT_EQ(channels[0].size(), 4u);
    EXPECT_NEAR(channels[0][3], 4 * band_radiance(5772, 3, 3.5), 1e-5 * 4 * band_radiance(5772, 3, 3.5));
}

TEST_F(Genirsky, SeaOfAPlaneIsSeenWhereItLies) {
    std::string text;
    for (int x = -400; x <= 400; x += 100)
        for (int y = -400; y <= 400; y += 100) text += formatted("%d %d %g\n", x, y, 30 + .02 * x - .01 * y);
    folder.write("sea.txt", text);
    make("sea -plane sea.txt -L -height 20 -at 10 -10 -horizon 36");
    const double along = 20 / std::tan(40 * std::numbers::pi / 180);  // 40 deg below the horizon
    const auto values = seen(
        {{0, 0, -1}, Frame{}.direction(-40, 0), Frame{}.direction(-40, 90), Frame{}.direction(-1e-6, 10)});
    EXPECT_NEAR(values[0][0], 30.3, single_precision);
    EXPECT_NEAR(values[1][0], 30.3 + .02 * along, single_precision);
    EXPECT_NEAR(values[2][0], 30.3 + .01 * along, single_precision);  // azimuth 90 is -y
    EXPECT_NEAR(values[3][0], 36, 1e-4);
    make("sea -plane sea.txt -L -height 20 -at 10 -10 -yup");
    EXPECT_NEAR(seen({Frame{.y_up = true}.direction(-40, 90)})[0][0], 30.3 - .01 * along, single_precision);
}

// Points are the scene's, however the table's azimuths stand.
TEST_F(Genirsky, APointOfTheSeaStaysWhereItIs) {
    folder.write("sea.txt", "0 -11.9 50\n0 11.9 1\n11.9 0 1\n-11.9 0 1\n0 0 1\n");
    for (const std::string turn : {"", " -turn 90", " -turn -18"}) {
        make("sea -plane sea.txt -L -height 10" + turn);
        const auto values = seen({{0, -.766, -.643}, {0, .766, -.643}, {.766, 0, -.643}});
        EXPECT_NEAR(values[0][0], 50, .01) << turn;
        EXPECT_NEAR(values[1][0], 1, .01) << turn;
        EXPECT_NEAR(values[2][0], 1, .01) << turn;
        make("sea -plane sea.txt -L -height 10 -yup" + turn);
        EXPECT_NEAR(seen({{0, -.643, -.766}})[0][0], 50, .01) << turn;
    }
    make("sea -plane sea.txt -L -height 10 -turn 30");  // between two of the table's azimuths
    EXPECT_GT(seen({{0, -.766, -.643}})[0][0], 49);
}

// A black panel of 25 C behind air of 15 C; the rays start 100, 500, 1000 and 2000 m before it.
TEST_F(Genirsky, AirIsReadByTheRenderers) {  // VALIDATION V11
    std::string text;
    for (const double range : {250., 1000.})
        text += test::tape7_run({.transmittance = std::exp(-range / 1000)});
    folder.write("paths.tp7", text);
    folder.write("panel.rad", formatted("void glow warm 0 0 4 %.9g 0 0 0\n", band_radiance(298.15, 8, 12)) +
                                  "warm ring panel 0 0 8 0 0 0 0 0 1 0 9\n");
    folder.write("rays", "0 0 100 0 0 -1\n0 0 500 0 0 -1\n0 0 1000 0 0 -1\n0 0 2000 0 0 -1\n");
    for (const std::string source : {"-homogeneous 288.15 1e-3", "-tape7 paths.tp7 -ranges 250,1000"}) {
        const Outcome traced = run(folder, "genirsky air " + source +
                                               " -b 8 12 -o path.air && oconv panel.rad > scene.oct && "
                                               "rtrace -h -mp path.air scene.oct < rays");
        ASSERT_EQ(traced.status, 0) << traced.err;
        std::istringstream words(traced.out);
        for (const double expected : {36.78782, 35.03729, 33.63683, 32.27220}) {
            double red = 0, other = 0;
            words >> red >> other >> other;
            EXPECT_NEAR(red, expected, 5e-5 * expected) << source;
        }
    }
}

TEST_F(Genirsky, SaysHowTheFileWasMade) {
    folder.write("sky.txt", "280 281 282 283 284 285 286 287 288 289\n");
    const Outcome made = run(folder, "genirsky sky -elev sky.txt -K -b 8 12 -id dome");
    EXPECT_TRUE(
        made.out.starts_with("# genirsky sky -elev sky.txt -K -b 8 12 -id dome\n"
                             "# sky radiance in W.m-2.sr-1, 8-12 um\n"
                             "# from sky.txt, temperatures in K\n"))
        << made.out;
    EXPECT_NE(made.out.find("\ndome_glow source dome\n"), made.out.npos);
}

TEST_F(Genirsky, RefusesWhatIsNotStated) {
    folder.write("ten", "1 2 3 4 5 6 7 8 9 10\n");
    folder.write("up.tp7", test::tape7_run({}) + test::tape7_run({}));
    folder.write("trans.tp7", test::tape7_transmittance_run(.5) + test::tape7_transmittance_run(.4));
    folder.write("out", "8000 1\n12000 1\n");
    EXPECT_EQ(error(""), "genirsky: what is it to be? (genirsky sky, sea, sun or air)\n");
    EXPECT_EQ(error("sjy"), "genirsky: \"sjy\" is none of sky, sea, sun and air (did you mean \"sky\"?)\n");
    EXPECT_EQ(error("sky"),
              "genirsky: nothing to make it from (-elev, -table, -thrend, -tape7 or -uvspec)\n");
    EXPECT_EQ(
        error("sky -elev ten"),
        "genirsky: the unit of the values is not stated (-L radiance in W.m-2.sr-1, -K kelvin, -C degrees "
        "Celsius)\n");
    EXPECT_EQ(error("sky -elev ten -K"),
              "genirsky: no band (-b 8 12 gives one in um, -r file a spectral response)\n");
    EXPECT_EQ(
        error("sky -elev ten -L -cs 8 -cw 8000 12000"),
        "genirsky: radiances of one band say nothing about channels (temperatures do, -K or -C, and spectra, "
        "-tape7 or -uvspec)\n");
    EXPECT_EQ(error("sky -elev ten -K -cs 7 -cw 8000 12000"), "genirsky: 7 channels (3..6, 8, 12 or 24)\n");
    EXPECT_EQ(error("sky -elev ten -K -b 12 8").substr(0, 10), "genirsky: ");
    EXPECT_EQ(error("sky -elev ten -table ten"),
              "genirsky: command line error at '-table ten': the source is given by -elev already\n");
    EXPECT_EQ(error("sky -tape7 up.tp7 -b 8 12"),
              "genirsky: the angles of -tape7's runs are not stated (-angles 0,30,60,85 in their order)\n");
    EXPECT_EQ(error("sky -tape7 up.tp7 -angles 0,30,60 -b 8 12"),
              "genirsky: the files hold 2 runs, but 3 angles are given (-angles, one for each run in the "
              "order of the "
              "files)\n");
    EXPECT_EQ(error("sky -tape7 up.tp7 -angles 30,30 -b 8 12"), "genirsky: -angles names 30 deg twice\n");
    EXPECT_EQ(
        error("sky -tape7 up.tp7 -angles 0,30 -b 3 5"),
        "genirsky: up.tp7:7: the band 3-5 um (2000-3333.33 cm-1) reaches beyond the file's 700-1400 cm-1\n");
    EXPECT_EQ(
        error("sky -tape7 trans.tp7 -angles 0,30 -b 8 12"),
        "genirsky: trans.tp7:6: a run of transmittances alone (IEMSCT 0) (radiance needs IEMSCT 1 or 2)\n");
    EXPECT_EQ(error("sky -uvspec out -columns lambda,uu -umu -1 -b 8 12"),
              "genirsky: the unit of the radiances is not stated (-unit W/m2/sr/nm, mW/m2/sr/nm, W/m2/sr/um, "
              "W/m2/sr/cm-1, mW/m2/sr/cm-1, W/cm2/sr/cm-1)\n");
    EXPECT_EQ(error("sea -plane ten -K -b 8 12"),
              "genirsky: -plane needs the height of the sensor (-height metres)\n");
    EXPECT_EQ(error("sun -b 3 5"),
              "genirsky: where is the sun? (-ang altitude azimuth or -dir x y z, one of them)\n");
    EXPECT_EQ(error("air -tape7 up.tp7 -b 8 12"),
              "genirsky: the lengths of the runs' paths are not stated (-ranges 100,1000 in metres)\n");
    EXPECT_EQ(error("air -homogeneous 288 1e-4"),
              "genirsky: no band (-b 8 12 gives one in um, -r file a response)\n");
    EXPECT_EQ(error("sky -elev ten -L -angles 0,30"), "genirsky: -angles is not read here (-tape7 does)\n");
    EXPECT_EQ(error("sky -uvspec out -unit W/m2/sr/nm -umu -1 -b 8 12"),
              "genirsky: -umu is not read here (-uvspec with -columns does)\n");
    EXPECT_EQ(error("sky -uvspec out -umu -1.5,-.5"),
              "genirsky: command line error at '-umu -1.5,-.5': umu must be within -1..1 and not 0\n");
    EXPECT_EQ(error("sky -uvspec out -umu -1,0"),
              "genirsky: command line error at '-umu -1,0': umu must be within -1..1 and not 0\n");
    EXPECT_EQ(
        error("sun -dir 0 0 1 -t -3 -b 3 5"),
        "genirsky: command line error at '-t -3': the temperature must be above 0 and at most 100000 K\n");
    folder.write("large", "0 1e31\n90 1e31\n");
    EXPECT_EQ(error("sky -elev large -L"), "genirsky: radiance 1e+31 is beyond 1e+30\n");
    EXPECT_NE(error("sky -elev nowhere -L").find("cannot read \"nowhere\""), std::string::npos);
}

TEST_F(Genirsky, WarnsOfWhatLooksLikeASlip) {
    const auto warning = [&](const std::string& arguments) {
        const Outcome outcome = run(folder, "genirsky " + arguments);
        EXPECT_EQ(outcome.status, 0) << arguments;
        return outcome.err;
    };
    folder.write("cold", "0 15\n90 18\n");
    EXPECT_EQ(warning("sky -elev cold -C -cs 4 -cw 8000 12000"), "");
    EXPECT_EQ(
        warning("sky -elev cold -K -cs 4 -cw 8000 12000"),
        "genirsky: warning: cold:1:3: temperature 15 K is below 100 K (degrees Celsius, -C?), and 1 more "
        "such value\n");
    std::string poles = node_table().replace(0, 2, "26");
    poles.resize(poles.rfind('\n', poles.size() - 2) + 1);  // the last column, which repeats the first
    folder.write("poles", poles);
    EXPECT_EQ(warning("sky -table poles -L"),
              "genirsky: warning: poles: the zenith has different values by azimuth: their mean is taken\n");
    EXPECT_EQ(warning("air -homogeneous 15 1e-4 -b 8 12"),
              "genirsky: warning: -homogeneous: temperature 15 K is below 100 K (degrees Celsius?)\n");
    EXPECT_EQ(warning("sun -dir 0 0 1 -b 3 5"), "");
}

TEST_F(Genirsky, WritesNoSunThatRenderersRefuse) {
    EXPECT_EQ(
        error("sun -dir 0 0 1 -half-angle 1e-9 -b 3 5"),
        "genirsky: command line error at '-half-angle 1e-9': the half-angle must be within 0.0001..90 deg\n");
    make("sun -dir 0 0 1 -half-angle 1e-4 -b 3 5");
    EXPECT_GT(seen({{0, 0, 1}})[0][0], 0);
}

TEST_F(Genirsky, LeavesNoPartOfAFile) {
    folder.write("bad", "280 281 282 -4 284 285 286 287 288 289\n");
    EXPECT_EQ(error("sky -elev bad -K -b 8 12 -o sky.rad"),
              "genirsky: bad:1:13: temperature -4 K is not above 0 K\n");
    EXPECT_FALSE(folder.has("sky.rad"));
    EXPECT_FALSE(folder.has("sky.rad.part"));
}

}  // namespace
}  // namespace infra::ir
