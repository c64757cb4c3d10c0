// What a rendering is split into, and what the surfaces of a scene are taken for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace infra {

/// Where light comes from that a surface reflects.
enum class Origin { sky, sea, sun, ship };
inline constexpr int origin_count = 4;

/// "sky", "sea", "sun", "ship".
std::string_view origin_name(Origin origin);
std::optional<Origin> origin_named(std::string_view name);

/// The option -split of rpict and those that go with it.
struct SplitSettings {
    int bounces = 1;  ///< counted one by one, the last with all that follow; 1: not told apart
    std::vector<std::pair<Origin, std::string>> modifiers;  ///< whose surfaces these are, the later ones win

    /// emitted, path, assumed, and one for each origin and bounce.
    int component_count() const { return 3 + origin_count * bounces; }
};

}  // namespace infra
