// brdftab: measured samples, MERL files and analytic models as regular .brdf tables for `nrlbrdf`.
//
//     brdftab -o paint.brdf -plot paint.svg -symmetrize paint.txt
//     brdftab -cox-munk 5 1.218 .0508 -clamp-energy -o sea.brdf
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "ir/brdftab/arguments.h"
#include "ir/brdftab/lobe_plot.h"
#include "ir/brdftab/repair.h"
#include "ir/brdftab/report.h"

namespace infra::ir {
namespace {

constexpr double degree = std::numbers::pi / 180;

BrdfSource open_source(const Arguments& arguments, const std::vector<std::string>& operands) {
    const char* usage = "brdftab [options] file, or a model's option and no file";
    if (arguments.make_source) {
        if (!operands.empty())
            throw Error("\"" + operands[0] + "\" and " + arguments.source_option + " are two sources", usage);
        return arguments.make_source();
    }
    if (operands.size() != 1) throw Error("give one file of samples", usage);
    return source_from_samples(operands[0], SampleLayout::columns, arguments.samples);
}

/// The source, held below 90 deg where it has no bound.
BrdfFunction bounded(const BrdfSource& source, const Arguments& arguments, std::string& notes) {
    if (source.bounded) return source.f;
    const double step = 90.0 / (std::max(arguments.grid.theta_i, arguments.grid.theta_r) - 1);
    const double limit = arguments.limit_deg > 0 ? arguments.limit_deg : 90 - step / 2;
    notes += formatted("model asked at most at: %g deg, held from there to 90\n", limit);
    return limited(source.f, limit * degree);
}

/// The grid, when a table may hold its values.
BrdfGrid checked(BrdfGrid grid) {
    for (std::size_t n = 0; n < grid.values.size(); ++n)
        if (!(std::isfinite(grid.values[n]) && grid.values[n] >= 0)) {
            const std::size_t block = n / static_cast<std::size_t>(grid.theta_r_count * grid.phi_count);
            throw Error(formatted("the BRDF is %g at theta_i = %g deg", static_cast<double>(grid.values[n]),
                                  90.0 * static_cast<double>(block) / (grid.theta_i_count - 1)),
                        "-limit holds a model below 90 deg");
        }
    return grid;
}

void write_plot(const Arguments& arguments, const BrdfSource& source, const BrdfTable& table) {
    LobePlot plot{source.description, arguments.plot_angles, arguments.plot_logarithmic};
    if (plot.incident_angles.empty()) plot.incident_angles = measured_incident_angles(source.samples);
    if (plot.incident_angles.empty()) plot.incident_angles = {20 * degree, 40 * degree, 60 * degree};
    const std::string svg = draw_lobes(table, source.samples, plot);
    AtomicFile file(arguments.plot);
    std::fwrite(svg.data(), 1, svg.size(), file.stream());
    file.commit();
}

int run(int argc, char** argv) {
    Arguments arguments;
    OptionTable options("brdftab", "[file]");
    describe_options(options, arguments);
    const auto operands = options.parse(argc, argv);
    if (!operands) return 0;

    const BrdfSource source = open_source(arguments, *operands);
    std::string notes = source.notes;
    BrdfFunction f = bounded(source, arguments, notes);
    if (arguments.symmetrize) {
        const BrdfTable before(checked(tabulate(f, arguments.grid)));
        notes += "reciprocity before -symmetrize: " + difference_text(reciprocity_error(before)) + "\n";
        f = symmetrized(f);
    }
    BrdfGrid grid = checked(tabulate(f, arguments.grid));
    if (arguments.clamp_energy) notes += energy_text(clamp_energy(grid));

    const BrdfTable table(grid);
    const std::string report = describe(source, f, table) + notes;
    std::fputs((report + albedo_lines(table, source.emissivity)).c_str(), stdout);
    std::fputs(energy_warning(table).c_str(), stderr);
    const std::string command =
        options.command_line() + (operands->empty() ? "" : " " + join_command(*operands));
    if (!arguments.output.empty())
        write_table(arguments.output, grid, command + "\n" + report,
                    arguments.band ? arguments.band : source.band);
    if (!arguments.plot.empty()) write_plot(arguments, source, table);
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("brdftab", infra::ir::run, argc, argv); }
