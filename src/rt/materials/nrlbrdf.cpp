// nrlbrdf: a measured isotropic BRDF from a table.
//
//     mod nrlbrdf id
//     1+ file.brdf...
//     0
//     5 R G B nsamp alpha
//     8 R G B nsamp alpha Er Eg Eb
//
// The BRDF is (R,G,B) times the table, times the patterns on `mod`. The largest constant that fits under the
// table joins the diffuse calculation, the rest is sampled by nsamp rays (for a ray of weight 1; at least
// one) drawn from the table and a Gaussian probe of RMS slope alpha, 0 < alpha <= 1: neither changes the
// mean. Er Eg Eb is emission as in emissive. File format: nrlbrdf/table_file.h.
//
// Several tables, in one file or more, each stand for a band of wavelengths; a channel of a spectral
// rendering gets their mean weighted by what its band has in common with theirs.
#include <utility>

#include "common/format.h"
#include "common/raypath.h"
#include "nrlbrdf/sampler.h"
#include "nrlbrdf/spectral_table.h"
#include "nrlbrdf/table_set.h"
#include "rt/compile/modifier_table.h"
#include "rt/compile/table_cache.h"
#include "rt/lobes/table.h"
#include "rt/materials/emissive_material.h"
#include "rt/materials/surface_material.h"

namespace infra {
namespace {

class TableMaterial final : public SurfaceMaterial {
  public:
    TableMaterial(std::string_view name, const Modifier* next, const Spectrum& color, double samples,
                  double alpha, const BrdfTables& tables)
        : SurfaceMaterial(name, next, false),
          color_(color),
          samples_(samples),
          sampler_(tables.distribution, alpha),
          spectral_(tables.spectral) {}

    void scatter(Tracer&, const Interaction& at, bool, Scattering& out) const override {
        const Spectrum color = color_ * at.pattern;
        const BrdfTable& table = sampler_.table();
        const double cosine = -dot(out.normal, at.ray->direction);
        const double albedo = table.lobe_reflectance_dh(cosine);
        if (spectral_) {
            out.diffuse = color * spectral_->diffuse_reflectance();
        } else {
            out.diffuse = color * static_cast<float>(table.diffuse_reflectance());
        }
        out.ambient = out.diffuse;
        if (albedo > 0)
            out.add_lobe<TableLobe>(true, lobe_coefficient(color, albedo, cosine), albedo, sampler_,
                                    spectral_.get(), out.normal, at.normal, -at.ray->direction, samples_);
    }

  private:
    Spectrum lobe_coefficient(const Spectrum& color, double albedo, double cosine) const {
        if (!spectral_) return color * static_cast<float>(albedo);
        Spectrum reflectance(color.channels());
        spectral_->lobe_reflectance_dh(cosine, reflectance);
        return color * reflectance;
    }

    Spectrum color_;
    double samples_;
    LobeSampler sampler_;
    std::shared_ptr<const SpectralTable> spectral_;
};

std::vector<LoadedTable> load_set(ModifierContext& context, const std::vector<std::string>& paths) {
    std::vector<LoadedTable> all;
    for (const std::string& path : paths)
        for (LoadedTable& table : load_tables(path)) {
            context.warnings.insert(context.warnings.end(), table.warnings.begin(), table.warnings.end());
            all.push_back(std::move(table));
        }
    order_table_set(all);
    if (all.size() > 1 && context.channels.is_rgb())
        throw context.error(
            formatted("%zu BRDF tables, each of a band, and no wavelengths to render", all.size()),
            "-cs and -cw choose spectral channels, or name one table");
    return all;
}

BrdfTables make_tables(ModifierContext& context, const std::vector<std::string>& paths) {
    std::vector<LoadedTable> set = load_set(context, paths);
    const ChannelShares shares = share_tables(context.channels, set);
    if (const std::string gaps = describe_gaps(context.channels, shares); !gaps.empty())
        context.warnings.push_back(Error(set.front().place, gaps).what());
    if (const int only = shares.only_table(); only >= 0) {
        auto& table = set[static_cast<std::size_t>(only)].table;
        return {std::make_shared<const TableDistribution>(std::move(table)), nullptr};
    }
    auto spectral = std::make_shared<const SpectralTable>(set, shares);
    return {std::make_shared<const TableDistribution>(spectral->mean_lobe()), spectral};
}

const BrdfTables& shared_tables(ModifierContext& context) {
    std::vector<std::string> paths;
    std::string key;
    for (const std::string_view name : context.strings()) {
        const auto path = find_library_file(name);
        if (!path)
            throw context.error("cannot find BRDF table \"" + std::string(name) + "\"",
                                "looked for in RAYPATH");
        paths.push_back(*path);
        key += *path + "\n";
    }
    auto [known, is_new] = context.tables.by_path.try_emplace(key);
    if (is_new) known->second = make_tables(context, paths);
    return known->second;
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
    auto table = std::make_unique<TableMaterial>(context.name(), context.next, context.color(0), samples,
                                                 alpha, shared_tables(context));
    if (numbers.size() == 5) return table;
    return std::make_unique<EmissiveMaterial>(context.name(), context.next, context.emission(5), 0.0,
                                              std::move(table));
}

}  // namespace infra
