#include "rt/programs/rtrace.h"

#include <bit>
#include <cstdio>
#include <optional>

#include "common/error.h"
#include "common/format.h"
#include "rt/programs/ambient_setup.h"
#include "rt/programs/persistent_server.h"
#include "rt/programs/ray_session.h"
#include "rt/programs/rtrace_options.h"

namespace infra {
namespace {

/// No date among the lines: the same command gives the same bytes.
std::string header_text(const std::vector<std::string>& first_lines, const RtraceOptions& options,
                        const OutputSpec& spec, const Channels& channels) {
    const OutputColor color = for_channels(options.color, channels);
    const int components = spec.components(ValueConverter(color, channels).components());
    std::string text = "#?RADIANCE\n";
    for (const std::string& line : first_lines) text += line + "\n";
    if (components > 0) text += formatted("NCOMP=%d\n", components);
    for (const std::string& line : color_header_lines(color, channels)) text += line + "\n";
    if (options.output == NumberFormat::floats || options.output == NumberFormat::doubles)
        text += formatted("BigEndian=%d\n", std::endian::native == std::endian::big ? 1 : 0);
    return text + "FORMAT=" + format_name(options.output, color) + "\n\n";
}

}  // namespace

int rtrace(int argc, char** argv) {
    RtraceOptions options;
    OptionTable table = rtrace_option_table(options);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;
    std::optional<PersistentServer> server;
    if (const std::string& file = options.render.persist_file; !file.empty()) {
        server.emplace(file, table.program());
        if (const std::optional<int> status = server->use()) return *status;
    }
    if (operands->empty()) throw Error("missing octree argument", "rays are read from the standard input");
    if (operands->size() > 1)
        throw Error("command line error at '" + operands->front() + "': one octree at a time");
    redirect_messages(options.render.error_file, table.command_line());
    const WarningSink warn = warning_sink(table.program(), options.render);
    const OutputSpec spec = output_spec(options, warn);

    if (const std::string text = color_warning(options.color, options.render.channels()); !text.empty())
        warn(text);
    const LoadedScene loaded = load_scene(operands->front(), options.render, warn);
    if (spec.needs_radiance())
        for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    if (server) server->leave_behind(!options.render.error_file.empty());
    const auto cache =
        open_irradiance_cache(loaded, options.render, table.program(), operands->front(), warn);
    std::string opening;
    if (options.header)
        opening = header_text(header_lines(loaded.header, table.command_line()), options, spec,
                              loaded.scene->channels());
    if (options.width > 0 && options.height > 0)
        opening += formatted("-Y %8d +X %8d\n", options.height, options.width);
    std::fwrite(opening.data(), 1, opening.size(), stdout);
    if (options.width > 0 && options.height <= 0) std::fflush(stdout);
    answer_rays(*loaded.scene, cache.get(), options, spec, stdin, stdout, warn);
    if (cache) cache->flush();
    return 0;
}

}  // namespace infra
