#include "rt/programs/rpict.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/error.h"
#include "common/interrupt.h"
#include "common/parse_number.h"
#include "rt/programs/ambient_setup.h"
#include "rt/programs/frame_name.h"
#include "rt/programs/persistent_server.h"
#include "rt/programs/picture_output.h"
#include "rt/programs/picture_session.h"
#include "rt/programs/rpict_options.h"
#include "rt/programs/view_sequence.h"

namespace infra {
namespace {

/// As RADIANCE: to end in good order, pixel and file included.
constexpr unsigned seconds_to_end = 15;

/// -r with the number of a picture in the sequence.
std::optional<int> recovered_number(const RpictOptions& options) {
    int number = 0;
    if (!options.is_sequence() || !parse_int(options.recover, number)) return std::nullopt;
    return number;
}

/// Combinations that cannot be.
void check(const RpictOptions& options, const std::vector<std::string>& operands) {
    if (operands.size() > 1)
        throw Error("command line error at '" + operands.front() + "': one octree at a time");
    if (!options.error_output.empty()) {
        if (options.samples_per_pixel < 2)
            throw Error("-se needs -spp 2 or more", "a single sample tells nothing of its error");
        if (!options.error_output.ends_with(".exr"))
            throw Error(Location{options.error_output}, "standard errors are written as OpenEXR",
                        "give a name that ends in .exr");
        if (options.color.kind == OutputColor::Kind::xyz ||
            options.color.kind == OutputColor::Kind::primaries)
            throw Error("-se gives the errors of the scene's own channels", "leave -pXYZ and -pc out");
    }
    if (options.render.settings.split) {
        if (options.split_output.empty()) throw Error("-splitb and -splitm need -split", "it names the file");
        if (!options.split_output.ends_with(".exr"))
            throw Error(Location{options.split_output}, "components are written as OpenEXR",
                        "give a name that ends in .exr");
        if (!options.render.settings.ambient_file.empty())
            throw Error("-af keeps no components", "leave -af or -split out");
    }
    if (options.is_sequence() && operands.empty())
        throw Error("missing octree argument", "views are read from the standard input");
    if (!options.render.persist_file.empty()) {
        if (!options.recover.empty()) throw Error("persist option used with recover file");
        if (!options.is_sequence()) throw Error("persist option only for sequences", "see -S");
    }
    if (const auto number = recovered_number(options)) {
        if (*number < options.first_number) throw Error("recover frame less than start frame");
        if (options.output.empty()) throw Error("missing output file specification", "see -o");
    }
}

void render_one(PictureSession& session, const RpictOptions& options, const Channels& channels,
                const WarningSink& warn) {
    RpictOptions named = options;
    named.output = frame_name(options.output, 0);
    named.depth_output = frame_name(options.depth_output, 0);
    std::optional<Recovery> recovery;
    if (!options.recover.empty())
        recovery = find_unfinished(frame_name(options.recover, 0), named, channels, warn);
    session.render(0, options.view, std::nullopt, std::move(recovery));
}

/// A picture for each view that comes in. One whose file is there already is another program's.
void render_sequence(PictureSession& session, const RpictOptions& options, const Channels& channels,
                     const WarningSink& warn) {
    ViewSequence views(stdin, "standard input", options.view);
    const bool numbered = has_frame_number(options.output);
    int number = options.first_number;
    const std::optional<int> recovered = recovered_number(options);
    for (; recovered && number < *recovered; ++number)
        if (!views.next()) throw Error("unexpected EOF on view input");
    bool recovering = !options.recover.empty();
    int pictures = 0;
    for (; views.next(); ++number) {
        RpictOptions named = options;
        named.output = frame_name(options.output, number);
        named.depth_output = frame_name(options.depth_output, number);
        std::optional<FrameClaim> claim;
        std::optional<Recovery> recovery;
        if (recovering) {
            recovery = find_unfinished(recovered ? named.output : options.recover, named, channels, warn);
            recovering = false;
        } else if (numbered) {
            claim.emplace(named.output);
            if (!claim->granted()) continue;
        } else if (!options.output.empty() && pictures > 0) {
            throw Error("a second picture would replace the first in \"" + options.output + "\"",
                        "put %d into the name of -o for the number");
        }
        // RADIANCE's: the picture numbered 1 is sharp.
        const bool has_motion = options.motion_blur > 0 && number > 1;
        session.render(number, views.view(), has_motion ? std::optional(views.previous()) : std::nullopt,
                       std::move(recovery));
        if (claim) claim->keep();
        ++pictures;
    }
    if (pictures == 0) warn("no output produced");
}

}  // namespace

int rpict(int argc, char** argv) {
    RpictOptions options;
    OptionTable table = rpict_option_table(options);
    const auto operands = table.parse(argc, argv);
    if (!operands) return 0;
    std::optional<PersistentServer> server;
    if (const std::string& file = options.render.persist_file; !file.empty()) {
        server.emplace(file, table.program());
        if (const std::optional<int> status = server->use()) return *status;
    }
    check(options, *operands);
    set_up_view(options.view);
    redirect_messages(options.render.error_file, table.command_line());
    const WarningSink warn = warning_sink(table.program(), options.render);
    check_writable(options);
    const Channels channels = options.render.channels();
    if (const std::string text = color_warning(options.color, channels.one_component());
        writes_colors(options) && !text.empty())
        warn(text);

    const std::string octree = operands->empty() ? "" : operands->front();
    const LoadedScene loaded = load_scene(octree, options.render, warn);
    for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    if (server) server->leave_behind(!options.render.error_file.empty());
    const auto cache = open_irradiance_cache(loaded, options.render, table.program(), octree, warn);
    const InterruptGuard guard(seconds_to_end);
    const std::string command_line = table.command_line();
    PictureSession session(loaded, options, cache.get(), table.program(), command_line, warn);
    if (options.is_sequence())
        render_sequence(session, options, channels, warn);
    else
        render_one(session, options, channels, warn);
    session.report_faults();
    return 0;
}

}  // namespace infra
