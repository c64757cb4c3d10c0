// Pictures of one scene, one after another: each is fitted to its view, rendered, written, and kept for later
// if a signal ends the program.
#pragma once

#include <optional>
#include <string>

#include "rt/ambient/irradiance_cache.h"
#include "rt/programs/distributed/fingerprint.h"
#include "rt/programs/distributed/frame_leader.h"
#include "rt/programs/frame_recovery.h"
#include "rt/programs/program_setup.h"
#include "rt/programs/render_frame.h"
#include "rt/programs/rpict_options.h"

namespace infra {

/// Where a team makes the pictures.
struct Distribution {
    FrameLeader leader;
    Fingerprint fingerprint;  ///< of all that pictures depend on besides their views
};

class PictureSession {
  public:
    /// Everything outlives this.
    ///   cache         of diffuse interreflection, for all pictures; nullptr: none
    ///   distribution  the team, or nullptr: this process is alone
    ///   command_line  of the program, for headers
    PictureSession(const LoadedScene& loaded, const RpictOptions& options, IrradianceCache* cache,
                   Distribution* distribution, const std::string& program, const std::string& command_line,
                   const WarningSink& warn);

    /// Renders one picture and writes it to the file that the options name, or to the standard output.
    ///   number    of the picture in a sequence, 0: there is none
    ///   view      set up; previous: of the picture before, if motion is to be blurred
    ///   recovery  what is known of it already; its view, if it has one, comes first
    ///   throws    Error for whatever prevents it; after a signal, Error "interrupted" that says where the
    ///             work is kept, if the picture has a file that can be named or the standard output is one
    void render(int number, const View& view, const std::optional<View>& previous,
                std::optional<Recovery> recovery);

    bool has_team() const { return distribution_ != nullptr; }

    /// What the same command has left of a picture when a team made it: it goes on from there unasked.
    ///   returns  nothing if nothing is left, or there is no team
    ///   throws   Error if what is left is another command's
    std::optional<Recovery> find_own(int number, const View& view, const std::optional<View>& previous) const;
    /// Whether it returns something.
    bool has_own(int number, const View& view, const std::optional<View>& previous) const;

    /// Warns of what went wrong while rays were traced, and prints what -stats asks for.
    void report() const {
        report_.warn_of_faults(warn_);
        report_.print_statistics(program_, options_.render, cache_);
    }

  private:
    std::string fingerprint_of(const View& view, const std::optional<View>& previous) const;
    [[noreturn]] void keep(const RpictOptions& options, const PartialFrame& partial,
                           const std::vector<std::string>& lines, int number) const;

    const LoadedScene& loaded_;
    const RpictOptions& options_;
    IrradianceCache* cache_;
    Distribution* distribution_;
    const std::string& program_;
    const std::string& command_line_;
    const WarningSink& warn_;
    Workers workers_;
    TracerReport report_;
};

}  // namespace infra
