#include "ir/brdftab/arguments.h"

#include <numbers>
#include <utility>

#include "common/format.h"
#include "nrlbrdf/coating_models.h"
#include "nrlbrdf/table_file.h"

namespace infra::ir {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Keeps what makes the source; a second one is an error.
void choose_source(Arguments& arguments, const OptionValues& given, std::function<BrdfSource()> make) {
    if (arguments.make_source) given.reject("the source is given by " + arguments.source_option + " already");
    arguments.make_source = std::move(make);
    arguments.source_option = given.option;
}

void choose_model(Arguments& arguments, const OptionValues& given, std::string name, BrdfFunction f,
                  bool bounded) {
    BrdfSource source{
        .f = std::move(f), .description = std::move(name), .bounded = bounded, .analytic = true};
    for (const std::string& value : given.values) source.description += " " + value;
    choose_source(arguments, given, [source] { return source; });
}

/// Refuses the n-th value outside low..high, ends included unless `inside`.
double ranged(const OptionValues& given, std::size_t n, const char* name, double low, double high,
              bool inside = false) {
    const double value = given.real(n);
    if (inside ? !(value > low && value < high) : !(value >= low && value <= high))
        given.reject(
            formatted("%s must be %s %g and %g", name, inside ? "strictly between" : "between", low, high));
    return value;
}

double positive(const OptionValues& given, std::size_t n, const char* name) {
    const double value = given.real(n);
    if (!(value > 0)) given.reject(formatted("%s must be above 0", name));
    return value;
}

double not_negative(const OptionValues& given, std::size_t n, const char* name) {
    const double value = given.real(n);
    if (!(value >= 0)) given.reject(formatted("%s must not be negative", name));
    return value;
}

void describe_files(OptionTable& options, Arguments& arguments) {
    options
        .custom(
            "-cuts", "s",
            [&arguments](const OptionValues& given) {
                choose_source(arguments, given, [&arguments, path = given.text(0)] {
                    return source_from_samples(path, SampleLayout::cuts, arguments.samples);
                });
            },
            "samples as tables, one for each incident angle, a column for each azimuth")
        .named("file");
    options
        .custom(
            "-merl", "s",
            [&arguments](const OptionValues& given) {
                choose_source(arguments, given, [&arguments, path = given.text(0)] {
                    return source_from_merl(path, arguments.channel);
                });
            },
            "MERL's binary of an isotropic surface")
        .named("file");
    options
        .custom(
            "-table", "s",
            [&arguments](const OptionValues& given) {
                choose_source(arguments, given, [path = given.text(0)] { return source_from_table(path); });
            },
            "a .brdf file of one table, for another grid, a band or a repair")
        .named("file.brdf");
    options
        .custom(
            "-channel", "s",
            [&arguments](const OptionValues& given) {
                const std::string& name = given.text(0);
                if (name != "r" && name != "g" && name != "b" && name != "mean")
                    given.reject("expected r, g, b or mean");
                arguments.channel = name == "r"   ? MerlChannel::red
                                    : name == "g" ? MerlChannel::green
                                    : name == "b" ? MerlChannel::blue
                                                  : MerlChannel::mean;
            },
            "channel of -merl")
        .named("r|g|b|mean");
    options
        .custom(
            "-mirror", "f",
            [&arguments](const OptionValues& given) {
                if (given.real(0) != 0 && given.real(0) != 180) given.reject("expected 0 or 180");
                arguments.samples.rules.mirror_at_zero = given.real(0) == 0;
            },
            "azimuth of the samples' mirror direction, 180 if not given")
        .named("0|180");
    options.toggle("-zero-negative", &arguments.samples.rules.negative_is_zero,
                   "negative samples are taken for 0", "negative samples are refused");
    options.toggle("-reciprocal", &arguments.samples.use_reciprocity,
                   "samples stand for exchanged directions too", "samples stand for themselves");
    options
        .custom(
            "-extrapolate", "s",
            [&arguments](const OptionValues& given) {
                const std::string& name = given.text(0);
                if (name != "constant" && name != "linear" && name != "zero")
                    given.reject("expected constant, linear or zero");
                arguments.samples.extrapolation = name == "constant" ? Extrapolation::constant
                                                  : name == "linear" ? Extrapolation::linear
                                                                     : Extrapolation::zero;
            },
            "beyond the largest angles measured, constant if not given")
        .named("constant|linear|zero");
}

void describe_models(OptionTable& options, Arguments& arguments) {
    const auto model = [&](const char* spelling, const char* pattern, auto apply, const char* help,
                           const char* names) {
        options
            .custom(
                spelling, pattern,
                [&arguments, apply](const OptionValues& given) { apply(arguments, given); }, help)
            .named(names);
    };
    model(
        "-lambert", "f",
        [](Arguments& all, const OptionValues& given) {
            choose_model(all, given, "Lambertian", lambertian(ranged(given, 0, "reflectance", 0, 1)), true);
        },
        "Lambertian", "reflectance");
    model(
        "-ward", "fff",
        [](Arguments& all, const OptionValues& given) {
            const double diffuse = ranged(given, 0, "diffuse", 0, 1);
            const double specular = ranged(given, 1, "specular", 0, 1);
            choose_model(all, given, "Ward", gaussian_lobe(diffuse, specular, positive(given, 2, "alpha")),
                         true);
        },
        "Lambertian and Ward's Gaussian lobe, bounded at grazing angles", "diffuse specular alpha");
    model(
        "-ggx", "ffff",
        [](Arguments& all, const OptionValues& given) {
            const double diffuse = ranged(given, 0, "diffuse", 0, 1), alpha = positive(given, 1, "alpha");
            choose_model(all, given, "GGX",
                         ggx(diffuse, alpha, positive(given, 2, "n"), not_negative(given, 3, "k")), false);
        },
        "Lambertian and GGX facets of index n + ik", "diffuse alpha n k");
    model(
        "-sandford-robertson", "ffff",
        [](Arguments& all, const OptionValues& given) {
            SandfordRobertson parameters;
            parameters.emissivity = ranged(given, 0, "emissivity", 0, 1);
            parameters.diffuse = ranged(given, 1, "diffuse", 0, 1 - parameters.emissivity);
            parameters.grazing = ranged(given, 2, "b", 0, 1, true);
            parameters.width = ranged(given, 3, "e", 0, 1, true);
            if ((parameters.emissivity + parameters.diffuse) / parameters.falloff_mean() > 1)
                given.reject("nothing is left for the lobe at normal incidence",
                             "emissivity + diffuse <= G(b)");
            choose_model(all, given, "Sandford-Robertson", sandford_robertson(parameters), false);
        },
        "Sandford and Robertson's paint", "emissivity diffuse b e");
    model(
        "-beard-maxwell", "ffffffff",
        [](Arguments& all, const OptionValues& given) {
            BeardMaxwell parameters;
            parameters.n = positive(given, 0, "n");
            parameters.k = not_negative(given, 1, "k");
            parameters.bias = not_negative(given, 2, "B");
            parameters.sigma = positive(given, 3, "sigma");
            parameters.diffuse = ranged(given, 4, "diffuse", 0, 1);
            parameters.volume = not_negative(given, 5, "volume");
            parameters.tau = positive(given, 6, "tau") * degree;
            parameters.omega = positive(given, 7, "omega") * degree;
            choose_model(all, given, "Beard-Maxwell", beard_maxwell(parameters), false);
        },
        "Maxwell and Beard's coating; tau and omega in degrees", "n k B sigma diffuse volume tau omega");
    model(
        "-cox-munk", "fff",
        [](Arguments& all, const OptionValues& given) {
            const Sea sea{ranged(given, 0, "wind", 0, 30), positive(given, 1, "n"),
                          not_negative(given, 2, "k")};
            choose_source(all, given, [sea] { return source_from_sea(sea); });
        },
        "sea under a wind in m/s, water of index n + ik", "wind n k");
    options
        .custom(
            "-limit", "f",
            [&arguments](const OptionValues& given) {
                arguments.limit_deg = ranged(given, 0, "limit", 0, 90, true);
            },
            "largest angle at which a model without bound is asked; else half a step below 90")
        .named("degrees");
}

void describe_output(OptionTable& options, Arguments& arguments) {
    options
        .custom(
            "-n", "iii",
            [&arguments](const OptionValues& given) {
                arguments.grid = {given.integer(0), given.integer(1), given.integer(2)};
                if (static_cast<double>(arguments.grid.theta_i) * arguments.grid.phi *
                        arguments.grid.theta_r >
                    static_cast<double>(max_table_values))
                    given.reject("the table is too large", formatted("at most %zu values", max_table_values));
            },
            "nodes of the table in theta_i, phi and theta_r")
        .named("Ni Np Nt")
        .at_least(2)
        .shown([&arguments] {
            return formatted("-n %d %d %d", arguments.grid.theta_i, arguments.grid.phi,
                             arguments.grid.theta_r);
        });
    options.text("-o", &arguments.output, "table to write").named("file.brdf");
    options
        .custom(
            "-band", "ff",
            [&arguments](const OptionValues& given) {
                const WavelengthBand band{positive(given, 0, "lo"), positive(given, 1, "hi")};
                if (!(band.lo_um < band.hi_um)) given.reject("the shorter wavelength stands first");
                arguments.band = band;
            },
            "wavelengths in um that the table states")
        .named("lo hi");
    options.toggle("-symmetrize", &arguments.symmetrize, "mean with directions exchanged: reciprocal",
                   "reciprocity as the source has it");
    options.toggle("-clamp-energy", &arguments.clamp_energy, "scaled down where reflectance is above 1",
                   "reflectance above 1 is reported");
    options.text("-plot", &arguments.plot, "polar diagrams to write").named("file.svg");
    options.toggle("-log", &arguments.plot_logarithmic, "logarithmic radius in -plot",
                   "linear radius in -plot");
    options
        .custom(
            "-angle", "f",
            [&arguments](const OptionValues& given) {
                arguments.plot_angles.push_back(ranged(given, 0, "angle", 0, 90) * degree);
                if (arguments.plot_angles.size() > 12) given.reject("at most 12 angles");
            },
            "incident angle for -plot, may be repeated; without it those measured, else 20, 40 and 60")
        .named("degrees");
}

}  // namespace

void describe_options(OptionTable& options, Arguments& arguments) {
    describe_files(options, arguments);
    describe_models(options, arguments);
    describe_output(options, arguments);
}

}  // namespace infra::ir
