#include "rt/programs/rpict.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/interrupt.h"
#include "common/parse_number.h"
#include "rt/programs/ambient_setup.h"
#include "rt/programs/distributed/agreement.h"
#include "rt/programs/distributed/fingerprint.h"
#include "rt/programs/distributed/frame_follower.h"
#include "rt/programs/distributed/shared_input.h"
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

/// Options that do not change a picture, and may differ when one goes on with what another has left.
constexpr std::string_view harmless_options[] = {"-n", "-t", "-w", "-ck", "-stats"};
/// Options that name files which are no input, besides.
constexpr std::string_view output_options[] = {"-n",     "-t", "-w",  "-ck", "-o", "-z", "-se",
                                               "-split", "-r", "-ro", "-af", "-P", "-PP"};

/// A process that others fork from, or one that is a fork, cannot be one of a team.
void check_team(const RpictOptions& options) {
    if (!options.render.persist_file.empty())
        throw Error("-P and -PP are not for several ranks", "all pictures of -S share one scene as it is");
}

void render_one(PictureSession& session, const RpictOptions& options, const Channels& channels,
                const WarningSink& warn) {
    RpictOptions named = options;
    named.output = frame_name(options.output, 0);
    named.depth_output = frame_name(options.depth_output, 0);
    std::optional<Recovery> recovery;
    if (!options.recover.empty())
        recovery = find_unfinished(frame_name(options.recover, 0), named, channels, warn);
    else
        recovery = session.find_own(0, options.view, std::nullopt);
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
        // RADIANCE's: the picture numbered 1 is sharp.
        std::optional<View> previous;
        if (options.motion_blur > 0 && number > 1) previous = views.previous();
        std::optional<FrameClaim> claim;
        std::optional<Recovery> recovery;
        if (recovering) {
            recovery = find_unfinished(recovered ? named.output : options.recover, named, channels, warn);
            recovering = false;
        } else if (numbered) {
            claim.emplace(named.output);
            const bool is_left = !claim->granted() && session.has_own(number, views.view(), previous);
            if (!claim->granted() && !(is_left && claim->take_over())) continue;
            if (session.has_team()) claim->lock();
        } else if (!options.output.empty() && pictures > 0) {
            throw Error("a second picture would replace the first in \"" + options.output + "\"",
                        "put %d into the name of -o for the number");
        }
        if (!recovery) recovery = session.find_own(number, views.view(), previous);
        session.render(number, views.view(), previous, std::move(recovery));
        if (claim) claim->keep();
        ++pictures;
    }
    if (pictures == 0) warn("no output produced");
}

/// Does what a team does in step, or a process alone.
void take_step_of(Team* team, const std::function<std::uint64_t()>& step) {
    if (team)
        take_step(*team, step);
    else
        step();
}

/// Of a team: all that its pictures depend on but their views.
Fingerprint fingerprint_of(const LoadedScene& loaded, const OptionTable& table, const RpictOptions& options,
                           const std::string& octree, const Bytes& input) {
    std::vector<std::string> words = split_words(table.command_line_without(output_options));
    std::erase(words, options.render.error_file);
    words.push_back(octree);
    Fingerprint fingerprint = fingerprint_of(loaded, table.command_line_without(harmless_options), words);
    fingerprint.add_text({input.data(), input.size()});
    return fingerprint;
}

int render_pictures(int argc, char** argv, Team* team) {
    const bool leads = !team || team->leads();
    RpictOptions options;
    OptionTable table = rpict_option_table(options);
    std::optional<std::vector<std::string>> operands;
    std::optional<PersistentServer> server;
    take_step_of(team, [&] {
        operands = table.parse(argc, argv);
        if (team) check_team(options);
        return operands ? 1 : 0;
    });
    if (!operands) {
        if (team) team->part();
        return 0;
    }
    if (const std::string& file = options.render.persist_file; !file.empty()) {
        server.emplace(file, table.program());
        if (const std::optional<int> status = server->use()) return *status;
    }
    Channels channels;
    take_step_of(team, [&] {
        check(options, *operands);
        set_up_view(options.view);
        if (leads) {
            redirect_messages(options.render.error_file, table.command_line());
            check_writable(options);
        }
        channels = options.render.channels();
        return 0;
    });
    const WarningSink warn = leads ? warning_sink(table.program(), options.render) : no_warnings();
    if (const std::string text = color_warning(options.color, channels.one_component());
        writes_colors(options) && !text.empty())
        warn(text);

    const std::string octree = operands->empty() ? "" : operands->front();
    const Bytes input = team && octree.empty() ? share_standard_input(*team) : Bytes();
    LoadedScene loaded;
    Fingerprint fingerprint;
    take_step_of(team, [&] {
        loaded = load_scene(octree, options.render, warn);
        if (team) fingerprint = fingerprint_of(loaded, table, options, octree, input);
        return fingerprint.value();
    });
    for (const std::string& warning : loaded.scene->warnings()) warn(warning);
    if (server) server->leave_behind(!options.render.error_file.empty());
    std::unique_ptr<IrradianceCache> cache;
    take_step_of(team, [&] {
        cache = open_irradiance_cache(loaded, options.render, table.program(), octree, warn);
        return 0;
    });
    if (team && options.threads == 0 && team->members_here() > 1) options.threads = 1;
    const InterruptGuard guard(seconds_to_end);
    if (!leads) {
        follow_frames(*team, loaded, options, cache.get());
        team->part();
        return 0;
    }
    const std::string command_line = table.command_line();
    std::optional<Distribution> distribution;
    if (team) distribution.emplace(FrameLeader(*team), fingerprint);
    const auto part = [&] {
        if (!distribution || !distribution->leader.is_idle()) return;
        distribution->leader.dismiss();
        team->part();
    };
    try {
        PictureSession session(loaded, options, cache.get(), distribution ? &*distribution : nullptr,
                               table.program(), command_line, warn);
        if (options.is_sequence())
            render_sequence(session, options, channels, warn);
        else
            render_one(session, options, channels, warn);
        session.report();
    } catch (const Error&) {
        if (!interrupted()) part();
        throw;
    }
    part();
    return 0;
}

}  // namespace

int rpict(int argc, char** argv) { return render_pictures(argc, argv, nullptr); }

int rpict(int argc, char** argv, Team& team) { return render_pictures(argc, argv, &team); }

}  // namespace infra
