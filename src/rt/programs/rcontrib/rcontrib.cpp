#include "rt/programs/rcontrib/rcontrib.h"

#include <cstdio>

#include "common/error.h"
#include "common/format.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/rcontrib/contribution_session.h"

namespace infra {
namespace {

/// What all outputs have in common. No date among the lines: the same command gives the same bytes.
std::string header_start(const LoadedScene& loaded, const std::string& command_line) {
    const Channels& channels = loaded.scene->channels();
    std::string text = "#?RADIANCE\n";
    for (const std::string& line : header_lines(loaded.header, command_line)) text += line + "\n";
    text += formatted("NCOMP=%d\n", channels.count());
    for (const std::string& line :
         color_header_lines(for_channels({OutputColor::Kind::spectrum}, channels), channels))
        text += line + "\n";
    return text;
}

void warn_of_unused(const ContributionPlan& plan, const WarningSink& warn) {
    const std::vector<std::string> names = plan.unused();
    if (names.size() == 1) warn("no surface has the modifier '" + names.front() + "'");
    if (names.size() > 1)
        warn(formatted("no surface has the modifier '%s', nor %zu others", names.front().c_str(),
                       names.size() - 1));
}

}  // namespace

int rcontrib(int argc, char** argv) {
    RcontribSettings settings;
    OptionTable table = rcontrib_option_table(settings);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;
    if (settings.modifiers.empty()) throw Error("missing required modifier argument", "-m name or -M file");
    if (operands->empty()) throw Error("missing octree argument", "rays are read from the standard input");
    if (operands->size() > 1)
        throw Error("command line error at '" + operands->front() + "': one octree at a time");
    redirect_messages(settings.render.error_file, table.command_line());
    const WarningSink warn = warning_sink(table.program(), settings.render);
    settings.apply_overrides();
    const BinFunctions bins(settings);
    std::vector<OutputTarget> targets = plan_outputs(settings, bins.rules(), warn);

    const LoadedScene loaded = load_scene(operands->front(), settings.render, warn);
    for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    const ContributionPlan plan(settings, bins, *loaded.scene);
    warn_of_unused(plan, warn);
    ContributionOutputs outputs(settings, std::move(targets),
                                settings.header ? header_start(loaded, table.command_line()) : "",
                                loaded.scene->channels());
    answer_contributions(plan, outputs, stdin, table.program(), warn);
    return 0;
}

}  // namespace infra
