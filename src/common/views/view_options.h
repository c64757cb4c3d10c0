// The view's rows of an option table: -vt -vp -vd -vu -vh -vv -vo -va -vs -vl -vf, in the order of RADIANCE's
// -defaults.
#pragma once

#include "common/options.h"
#include "common/views/view.h"

namespace infra {

/// `view` must outlive the table. Call set_up_view after parsing.
void add_view_options(OptionTable& table, View& view);

}  // namespace infra
