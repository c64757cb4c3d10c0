#include "ir/brdftab/source.h"

#include <utility>

#include "common/format.h"
#include "common/text_file.h"
#include "ir/brdftab/quality.h"
#include "ir/brdftab/sample_file.h"
#include "nrlbrdf/table_file.h"

namespace infra::ir {

BrdfSource source_from_samples(const std::string& path, SampleLayout layout, const SampleSettings& settings) {
    const std::string text = read_text_file(path);
    const auto parse = layout == SampleLayout::cuts ? parse_cuts : parse_columns;
    SampleSet set = parse(text, path, settings.rules);
    BrdfSource source;
    source.interpolator = std::make_shared<const SampleInterpolator>(
        distinct_samples(set.samples, settings.use_reciprocity), settings.extrapolation, path);
    source.f = [surface = source.interpolator](double theta_i, double phi, double theta_r) {
        return (*surface)(theta_i, phi, theta_r);
    };
    source.description = path + formatted(": %zu samples, %zu geometries%s", set.samples.size(),
                                          source.interpolator->samples().size(),
                                          settings.use_reciprocity ? " with their reciprocals" : "");
    if (set.negatives_zeroed > 0)
        source.notes = formatted("negative values taken for 0: %zu\n", set.negatives_zeroed);
    source.samples = std::move(set.samples);
    return source;
}

BrdfSource source_from_merl(const std::string& path, MerlChannel channel) {
    const auto table = std::make_shared<const MerlTable>(read_text_file(path), channel, path);
    constexpr const char* names[] = {"red", "green", "blue", "mean"};
    BrdfSource source;
    source.f = [table](double theta_i, double phi, double theta_r) {
        return (*table)(theta_i, phi, theta_r);
    };
    source.description = path + ": MERL, channel " + names[static_cast<int>(channel)];
    if (table->filled() > 0)
        source.notes = formatted("cells not measured, filled from the nearest: %zu\n", table->filled());
    return source;
}

BrdfSource source_from_table(const std::string& path) {
    const LoadedTable loaded = load_table(path);
    const auto [ni, np, nt, origin] = loaded.table->shape();
    BrdfSource source;
    source.f = [table = loaded.table](double theta_i, double phi, double theta_r) {
        return table_value(*table, theta_i, phi, theta_r);
    };
    source.description = path + formatted(": table of %d x %d x %d", ni, np, nt);
    source.band = loaded.band;
    return source;
}

BrdfSource source_from_sea(const Sea& sea) {
    BrdfSource source;
    source.f = cox_munk(sea);
    source.description = formatted("Cox-Munk sea, wind %g m/s, index %g + %gi", sea.wind, sea.n, sea.k);
    source.bounded = false;
    source.analytic = true;
    source.emissivity = [sea](double theta) { return sea_emissivity(sea, theta); };
    return source;
}

}  // namespace infra::ir
