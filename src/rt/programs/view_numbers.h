// A view as numbers, for files and messages.
#pragma once

#include <array>
#include <optional>

#include "common/views/view.h"

namespace infra {

using ViewNumbers = std::array<double, 25>;

/// Everything of a view that set_up_view leaves, so that its rays are the same to the last bit.
ViewNumbers numbers_of(const View& view);

/// The view; nothing for numbers whose rays would not be any.
std::optional<View> view_of(const ViewNumbers& numbers);

}  // namespace infra
