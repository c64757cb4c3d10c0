// The scene as the tracer sees it: surfaces, modifiers, light sources, function code. Immutable and shared by
// all threads.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cal/library.h"
#include "cal/program.h"
#include "common/data/air_path.h"
#include "common/spectra/channels.h"
#include "rt/compile/scene_part.h"
#include "rt/compile/surface_table.h"
#include "rt/geometry/geometry.h"
#include "rt/guiding/guide.h"
#include "rt/modifier.h"
#include "rt/settings.h"
#include "rt/sources/light_source.h"
#include "rt/volume/medium.h"
#include "scene/scene.h"

namespace infra {

/// A definition given with -e (text) or -f (file name).
struct FunctionDefinition {
    std::string text;
    bool is_file = false;
    std::string context = {};  ///< its names are known within; those that end in a back-quote everywhere
};

/// Adds it to a library: scenes and programs with expressions of their own do so alike.
///   throws  Error for bad syntax or a missing file
void add_definition(cal::Library& functions, const FunctionDefinition& definition);

class PhotonMaps;
class Split;

class CompiledScene {
  public:
    /// Compiles what the surfaces of `scene` use; the scene is kept for names and error places.
    ///   definitions  added to the function library after lib/rayinit.cal, in order
    ///   throws       Error for wrong arguments, undefined names, missing files, types whose shading is not
    ///   built yet
    static std::shared_ptr<const CompiledScene> compile(Scene scene, const RenderSettings& settings,
                                                        const Channels& channels,
                                                        const std::vector<FunctionDefinition>& definitions);

    const Channels& channels() const { return channels_; }
    int channel_count() const { return channels_.count(); }
    /// -av: radiance assumed where the bounces end.
    const Spectrum& ambient_value() const { return ambient_value_; }
    /// An error about a primitive, which is numbered as surfaces name it.
    Error error(PrimitiveId number, std::string_view message, std::string_view hint = {}) const;
    const Geometry& geometry() const { return geometry_; }
    const cal::Program& program() const { return *program_; }
    int surface_count() const { return static_cast<int>(surfaces_.surfaces.size()); }
    const Surface& surface(int i) const { return surfaces_[i]; }
    int finish_count() const { return static_cast<int>(surfaces_.finishes.size()); }
    /// Modifier and material of a surface.
    const Finish& finish(int surface) const { return surfaces_.finish(surface); }
    const std::vector<LightSource>& sources() const { return sources_; }
    const LightSource& source(int i) const { return sources_[static_cast<std::size_t>(i)]; }
    /// What shines: the surface of a source, or of that which a virtual one is an image of.
    int shining_surface(int source) const;
    /// Sources at infinity in the order of definition.
    const std::vector<int>& distant_sources() const { return distant_; }
    /// Sources that direct light is computed for.
    const std::vector<int>& sampled_sources() const { return sampled_; }

    /// A surface that emits and is not aimed at as a source, and a ball around it. Listed only for -gs above
    /// 0.
    struct EmittingSurface {
        int surface;
        Vec3 center;
        double radius;
    };
    const std::vector<EmittingSurface>& emitting_surfaces() const { return emitting_; }

    /// Where it is bright (-gs above 0), nullptr: nothing stands out.
    const Guide* guide() const { return guide_.get(); }

    /// White Lambertian of reflectance pi, which turns radiance into irradiance (-i, -I).
    const Modifier& irradiance_material() const { return *irradiance_material_; }

    /// Names for rtrace's -os, -om and -oM; "void" where there is none. surface >= 0.
    std::string_view surface_name(int surface) const;
    std::string_view modifier_name(int surface) const;
    std::string_view material_name(int surface) const;

    /// What fills the space outside all bodies and mists: -me.
    const Medium& surroundings() const { return surroundings_; }
    /// The same where it is something, else nullptr.
    const Medium* medium() const { return surroundings_.matters() ? &surroundings_ : nullptr; }

    /// The air along camera rays, nullptr for none.
    const AirPath* air() const { return air_ ? &*air_ : nullptr; }

    /// What -ap has read, nullptr for none.
    const PhotonMaps* photons() const { return photons_.get(); }

    /// How radiance is told apart by where it comes from, nullptr: it is not.
    const Split* split() const { return split_.get(); }

    /// Band in um that all thermal surfaces state; nothing if there are none or they differ.
    const std::optional<std::pair<double, double>>& band() const { return band_; }

    /// The texts that it was compiled from, without the coordinates of surfaces.
    const std::deque<ScenePart>& parts() const { return parts_; }

    /// Complete lines for the user, such as a table whose reflectance is over 1.
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    friend class SceneCompiler;
    CompiledScene() = default;
    const ScenePart& part_of(PrimitiveId number) const;
    CompiledScene(const CompiledScene&) = delete;
    CompiledScene& operator=(const CompiledScene&) = delete;

    Channels channels_;
    Spectrum ambient_value_{3};
    std::deque<ScenePart> parts_;  ///< the scene itself first
    std::vector<std::unique_ptr<Modifier>> modifiers_;
    std::unique_ptr<Modifier> irradiance_material_;
    SurfaceTable surfaces_;
    std::vector<std::unique_ptr<Geometry>> contents_;  ///< of instances and meshes
    Geometry geometry_{surfaces_};
    std::optional<AirPath> air_;
    std::shared_ptr<const PhotonMaps> photons_;
    std::shared_ptr<const Split> split_;
    Medium surroundings_{3};
    std::optional<std::pair<double, double>> band_;
    std::vector<LightSource> sources_;
    std::vector<int> distant_;
    std::vector<int> sampled_;
    std::vector<EmittingSurface> emitting_;
    std::unique_ptr<const Guide> guide_;
    std::unique_ptr<cal::Program> program_;
    std::vector<std::string> warnings_;
};

}  // namespace infra
