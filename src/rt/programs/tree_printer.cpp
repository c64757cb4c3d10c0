#include "rt/programs/tree_printer.h"

#include <algorithm>

namespace infra {

TreePrinter::TreePrinter(const CompiledScene& scene, const OutputSpec& spec, const NameFilter& filter,
                         NumberFormat format, const ValueConverter& converter, std::string& out)
    : scene_(scene), spec_(spec), filter_(filter), writer_(format, converter, out) {}

bool TreePrinter::passes(const Interaction& at) const {
    const bool including = filter_.mode == NameFilter::Mode::include;
    if (filter_.mode == NameFilter::Mode::none) return true;
    if (!at.hit()) return !including;
    const auto& names = filter_.names;
    const bool listed =
        std::find(names.begin(), names.end(), scene_.modifier_name(at.surface)) != names.end();
    return listed == including;
}

void TreePrinter::observe(const Interaction& at) {
    if (!passes(at)) return;
    int depth = 0;
    for (const Interaction* link = at.ray->parent; link; link = link->ray->parent) ++depth;
    writer_.indent(depth);
    for (const OutputLetter* letter : spec_.tree) letter->write(scene_, at, writer_);
    writer_.end_of_ray();
}

}  // namespace infra
