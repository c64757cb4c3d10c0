// nrlbrdf: a measured isotropic BRDF from a table.
//
//     mod nrlbrdf id
//     1 file.brdf
//     0
//     5 R G B nsamp alpha
//     8 R G B nsamp alpha Er Eg Eb
//
// The BRDF is (R,G,B) times the table, times the patterns on `mod`. The largest constant that fits under the
// table joins the diffuse calculation, the rest is sampled by nsamp rays (for a ray of weight 1; at least
// one) drawn from the table and a Gaussian probe of RMS slope alpha, 0 < alpha <= 1: neither changes the
// mean. Er Eg Eb is emission as in emissive. File format: nrlbrdf/table_file.h.
#include <cmath>

#include "common/raypath.h"
#include "nrlbrdf/sampler.h"
#include "nrlbrdf/table_file.h"
#include "rt/lobes/table.h"
#include "rt/materials/emissive_material.h"
#include "rt/materials/surface_material.h"
#include "rt/materials/table_cache.h"
#include "rt/modifier_table.h"

namespace infra {
namespace {

class TableMaterial final : public SurfaceMaterial {
  public:
    TableMaterial(std::string_view name, const Modifier* next, const Spectrum& color, double samples,
                  double alpha, std::shared_ptr<const TableDistribution> distribution)
        : SurfaceMaterial(name, next, false),
          color_(color),
          samples_(samples),
          sampler_(std::move(distribution), alpha) {}

    void scatter(const Interaction& at, bool, const RenderSettings&, bool, Scattering& out) const override {
        const Spectrum color = color_ * at.pattern;
        const BrdfTable& table = sampler_.table();
        out.diffuse = color * static_cast<float>(table.diffuse_reflectance());
        out.ambient = out.diffuse;
        const double albedo = table.lobe_reflectance_dh(-dot(out.normal, at.ray->direction));
        if (albedo > 0)
            out.add_lobe<TableLobe>(true, color, albedo, sampler_, out.normal, at.normal, -at.ray->direction,
                                    samples_);
    }

  private:
    Spectrum color_;
    double samples_;
    LobeSampler sampler_;
};

std::shared_ptr<const TableDistribution> shared_table(ModifierContext& context, std::string_view name) {
    const auto path = find_library_file(name);
    if (!path)
        throw context.error("cannot find BRDF table \"" + std::string(name) + "\"", "looked for in RAYPATH");
    auto& slot = context.tables.by_path[*path];
    if (!slot) {
        LoadedTable loaded = load_table(*path);
        context.warnings.insert(context.warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
        slot = std::make_shared<const TableDistribution>(std::move(loaded.table));
    }
    return slot;
}

}  // namespace

std::unique_ptr<Modifier> make_nrlbrdf(ModifierContext& context) {
    const auto numbers = context.reals();
    const double samples = numbers[3], alpha = numbers[4];
    for (int c = 0; c < 3; ++c)
        if (numbers[static_cast<std::size_t>(c)] < 0) throw context.error("R, G and B must not be negative");
    if (!(samples >= 1)) throw context.error("nsamp must be at least 1");
    if (!(alpha > 0 && alpha <= 1))
        throw context.error("alpha must lie in 0..1", "the RMS slope of the probe");
    auto distribution = shared_table(context, context.strings()[0]);
    auto table = std::make_unique<TableMaterial>(context.name(), context.next, context.color(0), samples,
                                                 alpha, std::move(distribution));
    if (numbers.size() == 5) return table;
    return std::make_unique<EmissiveMaterial>(context.name(), context.next, context.color(5), 0.0,
                                              std::move(table));
}

}  // namespace infra
