#include "ir/brdftab/report.h"

#include <cmath>
#include <map>
#include <numbers>

#include "common/format.h"

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// Above 1 by more than a printed table's rounding; load_table's threshold.
constexpr double energy_rounding = 1e-4;

/// Differences below this share are those of float values.
constexpr double rounding = 1e-6;

std::string place_text(double theta_i, double phi, double theta_r) {
    return formatted("theta_i %.4g, phi %.4g, theta_r %.4g deg", theta_i / degree, phi / degree,
                     theta_r / degree);
}

std::string errors_text(const char* what, const CrossValidation& left_out) {
    return formatted("%s, %zu samples: median %.3g %%, rms of log f %.3g, rms %.3g %% of rms f\n", what,
                     left_out.samples, 100 * left_out.median_ratio, left_out.rms_log,
                     100 * left_out.rms_over_rms) +
           formatted("  worst %.3g %% at ", 100 * left_out.worst_ratio) +
           place_text(left_out.worst.theta_i, left_out.worst.phi, left_out.worst.theta_r) + "\n";
}

std::string cross_validation_text(const SampleInterpolator& surface) {
    std::string text = errors_text("one sample left out", surface.leave_one_out());
    const CrossValidation angles = surface.leave_angle_out();
    if (angles.samples > 0) text += errors_text("one incident angle left out", angles);
    return text + formatted("scales: theta_d %g, imbalance %g; floor under log f: %.4g /sr\n",
                            surface.scale_theta_d(), surface.scale_imbalance(), surface.floor());
}

std::string extrapolation_text(const SampleInterpolator& surface, const BrdfTable& table) {
    int nodes = 0;
    for (int i = 0; i < table.theta_i_count(); ++i)
        for (int j = 0; j < table.theta_r_count(); ++j)
            nodes += surface.extrapolates(pi / 2 * i / (table.theta_i_count() - 1),
                                          pi / 2 * j / (table.theta_r_count() - 1));
    return formatted("extrapolated: %.3g %% of the nodes, beyond theta_i %.4g or theta_r %.4g deg\n",
                     100.0 * nodes / (table.theta_i_count() * table.theta_r_count()),
                     surface.largest_theta_i() / degree, surface.largest_theta_r() / degree);
}

std::string figure(bool present, double value) {
    return present ? formatted("%12.6f", value) : formatted("%12s", "-");
}

}  // namespace

std::string difference_text(const Difference& d) {
    if (d.rms < rounding && d.largest < rounding) return "none";
    std::string text = formatted("rms %.3g %%, up to 60 deg %.3g %% of the peak, largest %.3g %%",
                                 100 * d.rms, 100 * d.of_peak, 100 * d.largest);
    if (d.largest > 0) text += " at " + place_text(d.theta_i, d.phi, d.theta_r);
    return text;
}

std::string describe(const BrdfSource& source, const BrdfFunction& f, const BrdfTable& table) {
    std::string text = "source: " + source.description + "\n";
    if (source.interpolator)
        text += cross_validation_text(*source.interpolator) + extrapolation_text(*source.interpolator, table);
    text += "interpolation error between nodes: " + difference_text(interpolation_error(table, f)) + "\n";
    if (source.analytic) {
        const ReflectanceError error = reflectance_error(table, f);
        text += formatted("error of the reflectance: at most %.3g at %.4g deg, %.3g %%\n", error.largest,
                          error.theta / degree, 100 * error.relative);
    }
    return text + "reciprocity error: " + difference_text(reciprocity_error(table)) + "\n";
}

std::string energy_text(const EnergyRepair& repair) {
    if (repair.passes == 0)
        return formatted("energy: largest reflectance %.6f, nothing to clamp\n", repair.largest_before);
    return formatted("energy: largest reflectance %.6f, clamped to %.6f; smallest factor %.4f, %d passes\n",
                     repair.largest_before, repair.largest_after, repair.least_factor, repair.passes);
}

std::string albedo_lines(const BrdfTable& table, const std::function<double(double)>& model_emissivity) {
    struct Nodes {
        int incident = -1, viewed = -1;
    };
    std::map<long, Nodes> angles;  // by millidegrees, so that equal nodes meet
    const auto key = [](int n, int count) { return std::lround(90000.0 * n / (count - 1)); };
    for (int i = 0; i < table.theta_i_count(); ++i) angles[key(i, table.theta_i_count())].incident = i;
    for (int j = 0; j < table.theta_r_count(); ++j) angles[key(j, table.theta_r_count())].viewed = j;

    std::string lines = formatted("%12s%12s%12s%12s", "theta/deg", "R from", "R towards", "1 - R");
    lines += model_emissivity ? "  emissivity of the model, direct\n" : "\n";
    for (const auto& [millidegrees, nodes] : angles) {
        const bool incident = nodes.incident >= 0, viewed = nodes.viewed >= 0;
        const double theta = static_cast<double>(millidegrees) / 1000;
        const double from = incident ? table.incident_reflectance(nodes.incident) : 0;
        const double towards =
            viewed ? table.diffuse_reflectance() + table.lobe_reflectance_node(nodes.viewed) : 0;
        lines += formatted("%12.3f", theta) + figure(incident, from) + figure(viewed, towards) +
                 figure(viewed, 1 - towards);
        if (model_emissivity) lines += formatted("%12.6f", model_emissivity(theta * degree));
        lines += "\n";
    }
    return lines;
}

std::string energy_warning(const BrdfTable& table) {
    const double largest = largest_reflectance(table);
    if (largest <= 1 + energy_rounding) return "";
    return formatted(
        "brdftab: warning: the table reflects up to %.4f of what it receives "
        "(-clamp-energy scales it down)\n",
        largest);
}

}  // namespace infra::ir
