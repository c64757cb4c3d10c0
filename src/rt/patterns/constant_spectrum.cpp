#include "rt/patterns/constant_spectrum.h"

#include <algorithm>

#include "common/format.h"
#include "rt/compile/modifier_table.h"

namespace infra {

bool reaches_channels(ModifierContext& context, double nm_a, double nm_b) {
    const Channels& channels = context.channels;
    if (std::min(nm_a, nm_b) < channels.longest_nm() && std::max(nm_a, nm_b) > channels.shortest_nm())
        return true;
    context.warnings.push_back(
        context
            .error(formatted("a spectrum of %g to %g nm says nothing about a rendering of %g to %g nm", nm_a,
                             nm_b, channels.shortest_nm(), channels.longest_nm()),
                   "-cw names other wavelengths")
            .what());
    return false;
}

}  // namespace infra
