// The scene as the tracer sees it: surfaces, modifiers, light sources, function code. Immutable and shared by
// all threads.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cal/program.h"
#include "common/data/air_path.h"
#include "common/spectra/channels.h"
#include "rt/compile/surface_table.h"
#include "rt/geometry/geometry.h"
#include "rt/modifier.h"
#include "rt/settings.h"
#include "rt/sources/light_source.h"
#include "scene/scene.h"

namespace infra {

/// A definition given with -e (text) or -f (file name).
struct FunctionDefinition {
    std::string text;
    bool is_file = false;
};

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
    const Scene& text() const { return text_; }
    const Geometry& geometry() const { return geometry_; }
    const cal::Program& program() const { return *program_; }
    const Surface& surface(int i) const { return surfaces_[i]; }
    /// Modifier and material of a surface.
    const Finish& finish(int surface) const { return surfaces_.finish(surface); }
    const std::vector<LightSource>& sources() const { return sources_; }
    const LightSource& source(int i) const { return sources_[static_cast<std::size_t>(i)]; }
    /// Sources at infinity in the order of definition.
    const std::vector<int>& distant_sources() const { return distant_; }
    /// Sources that direct light is computed for.
    const std::vector<int>& sampled_sources() const { return sampled_; }

    /// White Lambertian of reflectance pi, which turns radiance into irradiance (-i, -I).
    const Modifier& irradiance_material() const { return *irradiance_material_; }

    /// Names for rtrace's -os, -om and -oM; "void" where there is none. surface >= 0.
    std::string_view surface_name(int surface) const;
    std::string_view modifier_name(int surface) const;
    std::string_view material_name(int surface) const;

    /// The air along camera rays, nullptr for none.
    const AirPath* air() const { return air_ ? &*air_ : nullptr; }

    /// Band in um that all thermal surfaces state; nothing if there are none or they differ.
    const std::optional<std::pair<double, double>>& band() const { return band_; }

    /// Complete lines for the user, such as a table whose reflectance is over 1.
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    friend class SceneCompiler;
    CompiledScene() = default;
    CompiledScene(const CompiledScene&) = delete;
    CompiledScene& operator=(const CompiledScene&) = delete;

    Channels channels_;
    Spectrum ambient_value_{3};
    Scene text_;
    std::vector<std::unique_ptr<Modifier>> modifiers_;
    std::unique_ptr<Modifier> irradiance_material_;
    SurfaceTable surfaces_;
    Geometry geometry_{surfaces_};
    std::optional<AirPath> air_;
    std::optional<std::pair<double, double>> band_;
    std::vector<LightSource> sources_;
    std::vector<int> distant_;
    std::vector<int> sampled_;
    std::unique_ptr<cal::Program> program_;
    std::vector<std::string> warnings_;
};

}  // namespace infra
