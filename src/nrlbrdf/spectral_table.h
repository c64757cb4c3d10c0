// The BRDFs of all channels of a rendering on one grid.
//
// Each channel has a Lambertian part D_c and a lobe, split as in table.h. Directions are drawn for all of
// them at once, from the distribution of the lobes' mean, which is zero only where all lobes are; what a
// channel has more or less of there is a factor on the sample. Channels of equal shares are one "tint". The
// tints of a node lie together, so that a look-up touches as many places in memory as that of a single table.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/spectra/spectrum.h"
#include "nrlbrdf/table.h"

namespace infra {

struct ChannelShares;
struct LoadedTable;

/// Immutable, so that threads share it. 4 bytes for each value of each tint, besides the mean.
class SpectralTable {
  public:
    /// tables: of equal grids; shares: those of each channel in them.
    ///   throws  infra::Error when tints times nodes are more than max_table_values
    SpectralTable(const std::vector<LoadedTable>& tables, const ChannelShares& shares);

    /// D_c.
    const Spectrum& diffuse_reflectance() const { return diffuse_; }

    /// Each channel's directional-hemispherical reflectance of the lobe, as BrdfTable::lobe_reflectance_dh.
    void lobe_reflectance_dh(double cos_theta_o, Spectrum& reflectance) const;

    /// Each channel's lobe f - D/pi [1/sr] over its reflectance for this viewer; 0 for a channel without
    /// lobe. Both directions above the surface.
    void normalized_lobe(const Vec3& wo, const Vec3& wi, Spectrum& result) const;

    /// Mean of the lobes over the channels, without Lambertian part: to draw directions from.
    const std::shared_ptr<const BrdfTable>& mean_lobe() const { return mean_; }

    int tint_count() const { return static_cast<int>(tint_count_); }

  private:
    struct Tints;  // those of a rendering, found before any memory is taken

    void mix_values(const std::vector<LoadedTable>& tables, const Tints& tints);
    void split_off_diffuse();
    void make_reflectances();
    void make_mean(const Tints& tints);

    GridShape shape_;
    std::size_t tint_count_ = 0;
    std::vector<std::uint8_t> tint_of_;  // per channel
    Spectrum diffuse_;
    std::vector<float> lobes_;         // per node, per tint
    std::vector<double> reflectance_;  // per viewing angle, per tint
    std::shared_ptr<const BrdfTable> mean_;
};

}  // namespace infra
