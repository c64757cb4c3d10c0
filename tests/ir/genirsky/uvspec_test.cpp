// uvspec's blocks and columns.
#include "ir/genirsky/uvspec.h"

#include "common/planck/planck.h"
#include "fixtures.h"
#include "ir/genirsky/atmosphere.h"

namespace infra::ir {
namespace {

using test::error_of;

UvspecLayout blocks(const std::string& unit = "mW/m2/sr/nm") {
    UvspecLayout layout;
    layout.unit = SpectralUnit::parse(unit);
    return layout;
}

UvspecLayout columns(std::vector<std::string> names, std::vector<double> umu, std::vector<double> phi = {}) {
    UvspecLayout layout = blocks("W/m2/sr/cm-1");
    layout.columns = std::move(names);
    layout.umu = std::move(umu);
    layout.phi = std::move(phi);
    return layout;
}

std::vector<UvspecRadiance> parse(const std::string& text, const UvspecLayout& layout) {
    return parse_uvspec(parse_numbers(text, "out"), layout);
}

std::string parse_error(const std::string& text, const UvspecLayout& layout) {
    return error_of([&] { parse(text, layout); });
}

constexpr const char* fluxes = " 1.0 2.0 3.0 .1 .2 .3\n";

TEST(Uvspec, ReadsBlocksWithAzimuths) {
    const std::string text = std::string("8000.0") + fluxes +
                             "       0 90 180\n-1.0 5 1 1 1\n-0.5 5 2 3 4\n" + "12000.0" + fluxes +
                             "       0 90 180\n-1.0 5 6 6 6\n-0.5 5 7 8 9\n";
    const auto radiances = parse(text, blocks("W/m2/sr/cm-1"));
    ASSERT_EQ(radiances.size(), 6u);
    EXPECT_EQ(radiances[4].umu, -.5);
    EXPECT_EQ(radiances[4].phi, 90);
    EXPECT_EQ(radiances[4].radiance.place, (std::vector<double>{8, 12}));
    EXPECT_EQ(radiances[4].radiance.value, (std::vector<double>{3, 8}));
    EXPECT_EQ(radiances[4].radiance.axis, SpectralAxis::wavelength);
    EXPECT_EQ(radiances[4].radiance.density, SpectralAxis::wavenumber);
}

TEST(Uvspec, ReadsBlocksWithoutAzimuths) {
    const std::string text =
        std::string("8000.0") + fluxes + "-1.0 5\n0.5 6\n" + "12000.0" + fluxes + "-1.0 7\n0.5 8\n";
    const auto radiances = parse(text, blocks("W/m2/sr/cm-1"));
    ASSERT_EQ(radiances.size(), 2u);
    EXPECT_FALSE(radiances[0].phi);
    EXPECT_EQ(radiances[1].radiance.value, (std::vector<double>{6, 8}));
}

TEST(Uvspec, ReadsColumns) {
    const auto layout = columns({"sza", "wavenumber", "uu", "edn"}, {-1, -.5}, {0, 180});
    const auto radiances = parse("30 900 1 2 3 4 .1\n30 950 5 6 7 8 .1\n", layout);
    ASSERT_EQ(radiances.size(), 4u);
    EXPECT_EQ(radiances[2].umu, -.5);
    EXPECT_EQ(radiances[2].phi, 0);
    EXPECT_EQ(radiances[2].radiance.value, (std::vector<double>{3, 7}));
}

TEST(Uvspec, KnowsItsUnits) {
    const auto is = [](const char* name, double watts, SpectralAxis density) {
        const SpectralUnit unit = SpectralUnit::parse(name);
        EXPECT_DOUBLE_EQ(unit.watts(3), 3 * watts) << name;
        EXPECT_EQ(unit.density(), density) << name;
    };
    is("W/m2/sr/nm", 1e3, SpectralAxis::wavelength);
    is("mW/m2/sr/nm", 1, SpectralAxis::wavelength);
    is("W/m2/sr/um", 1, SpectralAxis::wavelength);
    is("mW/m2/sr/cm-1", 1e-3, SpectralAxis::wavenumber);
    is("W/cm2/sr/cm-1", 1e4, SpectralAxis::wavenumber);
    EXPECT_EQ(error_of([] { SpectralUnit::parse("W"); }),
              "unknown unit \"W\" (W/m2/sr/nm, mW/m2/sr/nm, W/m2/sr/um, W/m2/sr/cm-1, mW/m2/sr/cm-1, "
              "W/cm2/sr/cm-1)");
    EXPECT_EQ(
        parse_error("8000 1 2 3\n", {}),
        "the unit of the radiances is not stated (-unit W/m2/sr/nm, mW/m2/sr/nm, W/m2/sr/um, W/m2/sr/cm-1, "
        "mW/m2/sr/cm-1, W/cm2/sr/cm-1)");
}

/// Grey isothermal air of vertical depth .4 at umu, as mW m^-2 sr^-1 nm^-1.
std::string grey_blocks(const std::vector<double>& umus) {
    std::string text;
    for (double nm = 7900; nm <= 12100; nm += 10) {
        text += formatted("%10.3f", nm) + fluxes;
        for (const double umu : umus)
            text += formatted(
                "%9.6f %.6e\n", umu,
                1e3 * 1e-3 * (1 - std::exp(-.4 / std::abs(umu))) * spectral_radiance(288.15, nm / 1000));
    }
    return text;
}

TEST(Uvspec, IntegratesToTheClosedForm) {
    const auto radiances = parse(grey_blocks({-1, -.5}), blocks());
    const double expected = (1 - std::exp(-.8)) * band_radiance(288.15, 8, 12);
    EXPECT_NEAR(band_integral(radiances[1].radiance, Passband::of_band(8, 12)), expected, 1e-5 * expected);
}

TEST(Uvspec, MakesASkyWithoutAzimuth) {
    const double angle = 50 * std::numbers::pi / 180;
    const Dome dome = dome_of_uvspec(parse(grey_blocks({-1, -std::cos(angle), .5}), blocks()), true,
                                     Passband::of_band(8, 12));
    ASSERT_EQ(dome.values.size(), 10u);
    const double black = band_radiance(288.15, 8, 12);
    EXPECT_NEAR(dome.values[0], (1 - std::exp(-.4)) * black, 1e-4);
    EXPECT_NEAR(dome.values[5], (1 - std::exp(-.4 / std::cos(angle))) * black, 1e-4);
    EXPECT_NEAR(dome.values[3], dome.values[0] + .6 * (dome.values[5] - dome.values[0]), 1e-4);
    EXPECT_EQ(dome.values[9], dome.values[5]);
}

/// Radiances of 1 W m^-2 sr^-1 a band of 8-12 um times `value` in the two directions of one phi.
UvspecRadiance constant(double umu, double phi, double value) {
    const double width = 1e4 / 8 - 1e4 / 12;
    return {umu, phi, {"out", {800, 1300}, {value / width, value / width}}};
}

TEST(Uvspec, TurnsFlightIntoViews) {
    std::vector<UvspecRadiance> radiances;
    for (const double phi : {0., 90., 180., 270.})
        for (const double umu : {-1., -.1}) radiances.push_back(constant(umu, phi, 1 + phi));
    const Dome dome = dome_of_uvspec(radiances, true, Passband::of_band(8, 12));
    ASSERT_EQ(dome.values.size(), 210u);
    const auto at = [&](std::size_t column) { return dome.values[10 * column + 5]; };
    EXPECT_NEAR(at(0), 181, 1e-9);              // looking north: radiation goes south
    EXPECT_NEAR(at(5), 271, 1e-9);              // looking east: it goes west
    EXPECT_NEAR(at(10), 1, 1e-9);               // looking south
    EXPECT_NEAR(at(15), 91, 1e-9);              // looking west
    EXPECT_NEAR(at(8), 271 + .6 * -270, 1e-9);  // azimuth 144, phi 324
    EXPECT_EQ(at(20), at(0));
}

TEST(Uvspec, MirrorsHalfACircle) {
    std::vector<UvspecRadiance> radiances;
    for (const double phi : {0., 60., 180.})
        for (const double umu : {-1., -.1}) radiances.push_back(constant(umu, phi, 1 + phi));
    const Dome dome = dome_of_uvspec(radiances, true, Passband::of_band(8, 12));
    for (std::size_t column = 0; column <= 20; ++column) {
        const double phi = std::fmod(18. * static_cast<double>(column) + 180, 360);
        EXPECT_NEAR(dome.values[10 * column + 5], 1 + std::min(phi, 360 - phi), 1e-9) << column;
    }
}

// As the table of 210 values: 360 deg repeats 0 deg.
TEST(Uvspec, ClosesTheCircle) {
    const std::string head = std::string("8000") + fluxes + "0 180 360\n",
                      tail = std::string("12000") + fluxes + "0 180 360\n-1 5 4 5 4\n-.5 5 1 2 1\n";
    const auto radiances = parse(head + "-1 5 1 2 1\n-.5 5 3 4 3\n" + tail, blocks());
    ASSERT_EQ(radiances.size(), 4u);
    EXPECT_EQ(radiances[3].phi, 180);
    EXPECT_EQ(radiances[3].radiance.value, (std::vector<double>{4, 2}));
    EXPECT_EQ(dome_of_uvspec(radiances, true, Passband::of_band(8, 12)).values.size(), 210u);
    EXPECT_EQ(parse_error(head + "-1 5 1 2 1\n-.5 5 3 4 3.1\n" + tail, blocks()),
              "out:4:11: the radiance 3.1 is not that of phi 0 in the same direction, 3");

    const auto layout = columns({"lambda", "uu", "sza"}, {-1, -.5}, {-180, 0, 180});
    const auto lines = parse("8000 1 2 1 3 4 3 0\n12000 5 6 5 7 8 7 0\n", layout);
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[2].radiance.value, (std::vector<double>{3, 7}));
    EXPECT_EQ(parse_error("8000 1 2 1 3 4 2 0\n", layout),
              "out:1:16: the radiance 2 is not that of phi -180 in the same direction, 3");
}

TEST(Uvspec, NeedsTheRightHalfSpace) {
    const auto up = parse(grey_blocks({-1, -.5}), blocks());
    EXPECT_EQ(error_of([&] { dome_of_uvspec(up, false, Passband::of_band(8, 12)); }),
              "fewer than 2 upwelling radiances (a sea needs umu above 0, radiances that go up)");
}

TEST(Uvspec, RefusesADirectionTwice) {
    const std::vector<UvspecRadiance> radiances{constant(-1, 0, 1), constant(-.5, 0, 1),
                                                constant(-.5, 360, 1)};
    EXPECT_EQ(error_of([&] { dome_of_uvspec(radiances, true, Passband::of_band(8, 12)); }),
              "out: two radiances 60 deg from the pole at phi 0");
}

TEST(Uvspec, NamesWhatIsWrong) {
    const std::string one = std::string("8000") + fluxes, two = std::string("9000") + fluxes;
    const std::string hint = " (-columns tells what output_user wrote)";
    EXPECT_EQ(parse_error(one + "-1 5\n", blocks()), "out:2: a spectrum needs at least 2 wavelengths");
    EXPECT_EQ(parse_error(one + "-1 5\n" + one + "-1 5\n", blocks()),
              "out:3:1: the spectrum is out of order (one output level (zout) and one time a file, "
              "wavelengths in order)");
    EXPECT_EQ(parse_error(one + two, blocks()), "out:2:1: expected a line that begins with umu" + hint);
    EXPECT_EQ(parse_error(one, blocks()), "out:1: the last block is cut off or has no radiances" + hint);
    EXPECT_EQ(parse_error("-1 5\n", blocks()),
              "out:1:1: expected a line that begins with a wavelength in nm" + hint);
    EXPECT_EQ(parse_error(one + "-1 5\n-.5 6\n" + two + "-1 5\n", blocks()),
              "out:5: the block has not the directions of the first");
    EXPECT_EQ(parse_error(one + "-1 5\n" + two + "-.9 5\n", blocks()),
              "out:4:1: the block has not the directions of the first");
    EXPECT_EQ(parse_error(one + "-1 -5\n", blocks()), "out:2:4: negative radiance -5");
    EXPECT_EQ(parse_error(one + "0 90\n-1 5 1 1\n-.5 5 1\n", blocks()),
              "out:4:1: found 3 numbers where umu, u0u and uu make 4");
    EXPECT_EQ(parse_error("9000 1 2\n9100 1\n", columns({"lambda", "uu"}, {-1, -.5})),
              "out:2: found 2 numbers where -columns makes 3");
    EXPECT_EQ(parse_error("-1 1\n", columns({"lambda", "uu"}, {-1})),
              "out:1:1: a wavelength must be above 0 nm");
    EXPECT_EQ(parse_error("1 1\n", columns({"uu"}, {-1})),
              "-columns must name either lambda or wavenumber, once (-columns lambda,uu)");
    EXPECT_EQ(parse_error("1 1\n", columns({"lambda", "uu"}, {})),
              "the directions of uu are not stated (-umu -1,-.5,-.1 as in uvspec's input)");
    EXPECT_EQ(parse_error("1 1\n", columns({"lambda", "edn"}, {})),
              "-columns names no radiances (-columns lambda,uu)");
}

TEST(Uvspec, ReadsPathsFromColumns) {
    const auto layout = columns({"wavenumber", "transmittance", "radiance"}, {});
    const PathSpectra path = parse_path_columns(parse_numbers("900 .5 1\n950 .6 2\n", "out"), layout);
    EXPECT_EQ(path.transmittance.value, (std::vector<double>{.5, .6}));
    EXPECT_EQ(path.radiance.value, (std::vector<double>{1, 2}));
    EXPECT_EQ(error_of([&] { parse_path_columns(parse_numbers("900 1.5 1\n", "out"), layout); }),
              "out:1:5: transmittance 1.5 is not within 0..1");
}

}  // namespace
}  // namespace infra::ir
