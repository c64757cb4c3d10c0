#include "bsdf/bsdf.h"

#include <algorithm>
#include <numbers>

#include "bsdf/matrix_reader.h"
#include "bsdf/tree_reader.h"
#include "common/format.h"

namespace infra {
namespace {

constexpr double most_scattering = 1.01;  // that is taken without a warning

const char* description(const ScatterSides& sides) {
    if (sides.transmits) return sides.from_front ? "Transmission Back" : "Transmission Front";
    return sides.from_front ? "Reflection Back" : "Reflection Front";
}

void warn_of_excess(const WindowElement& element, const ScatterTable& table,
                    std::vector<std::string>& warnings) {
    const double sum = table.lambertian().y + table.largest_total();
    if (sum <= most_scattering) return;
    warnings.push_back(Error(element.place, formatted("%s scatters %.1f %% of the light",
                                                      description(table.sides()), 100 * sum))
                           .what());
}

LoadedBsdf make_bsdf(WindowElement element) {
    LoadedBsdf result;
    std::vector<std::unique_ptr<ScatterTable>> tables;
    const auto has = [&](std::string_view structure) { return same_name(element.data_structure, structure); };
    if (has("TensorTree3") || has("TensorTree4"))
        tables = read_trees(element, result.warnings);
    else if (has("Rows") || has("Columns"))
        tables = read_matrices(element, result.warnings);
    else
        throw Error(element.structure_place,
                    "unknown <IncidentDataStructure> \"" + element.data_structure + "\"",
                    "Columns, Rows, TensorTree3 or TensorTree4");
    if (tables.empty())
        throw Error(element.place, "no scattering data of the wavelength Visible",
                    "these are what is rendered; CIE-X and CIE-Z, or CIE-u and CIE-v, add colour");
    for (const auto& table : tables) warn_of_excess(element, *table, result.warnings);
    result.bsdf = std::make_shared<const Bsdf>(std::move(element.description), std::move(tables));
    return result;
}

}  // namespace

Bsdf::Bsdf(BsdfDescription about, std::vector<std::unique_ptr<ScatterTable>> tables)
    : description_(std::move(about)) {
    bool has_transmission[2] = {false, false};
    for (auto& table : tables) {
        const auto [front, transmits] = table->sides();
        (transmits ? lambertian_transmittance_ : lambertian_reflectance_)[front] = table->lambertian();
        if (transmits) has_transmission[front] = true;
        if (table->largest_total() > least_total)
            (transmits ? transmission_ : reflection_)[front] = std::move(table);
    }
    one_way_ = has_transmission[0] != has_transmission[1];
    way_ = has_transmission[1];
    if (one_way_) lambertian_transmittance_[!way_] = lambertian_transmittance_[way_];
}

ResolutionRange Bsdf::resolution(const Vec3& in) const {
    const bool front = in.z > 0;
    ResolutionRange range{10, 0};
    for (const ScatterTable* table : {reflection(front), transmission(front)}) {
        if (!table) continue;
        const ResolutionRange own = table->resolution(in);
        range = {std::min(range.least, own.least), std::max(range.largest, own.largest)};
    }
    if (!(range.largest > 0)) return {std::numbers::pi, std::numbers::pi};
    return range;
}

LoadedBsdf load_bsdf(const std::string& path) { return make_bsdf(read_window_element(path)); }

LoadedBsdf parse_bsdf(std::string_view text, const std::string& name) {
    return make_bsdf(parse_window_element(text, name));
}

}  // namespace infra
