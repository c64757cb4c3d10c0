// Radiance told apart by where it comes from.
//
// A split rendering has every channel once for each component, and is otherwise a rendering like any other:
// reflectance, patterns and transmittance are the same in all components, so that all that is linear (lobes,
// hemispheres, cached irradiance, mixtures, media) needs to know nothing of them. What a surface emits goes
// into the first component. When a ray that has been scattered brings radiance back, all of it becomes light
// that was reflected, and the surface which the ray has met says what of: sky, sea, sun or ship.
//
// So a component is what the surface *seen* reflects of what *arrives* there. The sky's light that the sea
// reflects onto a hull is light from the sea.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/spectra/channels.h"
#include "rt/split/split_settings.h"

namespace infra {

class CompiledScene;

class Split {
  public:
    /// The components, of which these come first.
    enum Component {
        emitted,  ///< by what is seen itself, sky and sea included
        path,     ///< by the air before it (-mp), and scattered by mist and by the medium around it (-me)
        assumed,  ///< reflected of the radiance that -av assumes at the surface seen
        first_reflected
    };

    /// Finds out what each surface of a compiled scene is:
    ///   - what the settings say of its modifier or of one that this has behind it;
    ///   - else, of type source: the sun if it is narrower than 10 degrees, sea if its middle lies below the
    ///     horizon (Z is up), sky otherwise;
    ///   - else: ship.
    ///   throws  Error for a modifier that no surface has
    Split(const CompiledScene& scene, const SplitSettings& settings);

    Origin origin(int surface) const {
        return static_cast<Origin>(origins_[static_cast<std::size_t>(surface)]);
    }

    /// Makes what a ray that ends on `surface` brings back, if it was scattered before, reflected light.
    ///   surface  -1: nothing was met
    void arrive(int surface, Spectrum& radiance) const;
    /// Makes all of it light that comes from the path.
    void into_path(Spectrum& radiance) const;
    /// What the path has of light that is the same in all components.
    Spectrum on_path(const Spectrum& radiance) const { return channels_.in_component(path, radiance); }

  private:
    int reflected(int origin, int bounce) const { return first_reflected + origin * bounces_ + bounce - 1; }

    Channels channels_;
    int bounces_;
    std::vector<std::uint8_t> origins_;  ///< by surface
};

/// Names of the components: "emitted", "path", "assumed", "reflected_sky", "reflected_sea", ...; with more
/// than one bounce "reflected_sky1", "reflected_sky2", ...
std::vector<std::string> component_names(const SplitSettings& settings);

}  // namespace infra
