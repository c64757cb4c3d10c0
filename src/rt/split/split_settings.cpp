#include "rt/split/split_settings.h"

#include <algorithm>
#include <array>

namespace infra {
namespace {

constexpr std::array<std::string_view, origin_count> names = {"sky", "sea", "sun", "ship"};

}  // namespace

std::string_view origin_name(Origin origin) { return names[static_cast<std::size_t>(origin)]; }

std::optional<Origin> origin_named(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Origin>(found - names.begin());
}

}  // namespace infra
