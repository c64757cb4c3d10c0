#include "nrlbrdf/spectral_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/format.h"
#include "nrlbrdf/table_set.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

struct SpectralTable::Tints {
    explicit Tints(const ChannelShares& channels) {
        for (const TableShares& own : channels.of_channel) {
            const auto known = std::ranges::find(shares, own);
            of_channel.push_back(static_cast<std::uint8_t>(known - shares.begin()));
            if (known == shares.end()) {
                shares.push_back(own);
                channel_count.push_back(0);
            }
            ++channel_count[of_channel.back()];
        }
    }
    std::vector<TableShares> shares;
    std::vector<int> channel_count;
    std::vector<std::uint8_t> of_channel;
};

SpectralTable::SpectralTable(const std::vector<LoadedTable>& tables, const ChannelShares& shares)
    : shape_(tables.front().table->shape()), diffuse_(static_cast<int>(shares.of_channel.size())) {
    const Tints tints(shares);
    tint_count_ = tints.shares.size();
    tint_of_ = tints.of_channel;
    if (shape_.size() > max_table_values / tint_count_)
        throw Error(tables.front().place,
                    formatted("%zu values for each of %zu channels that differ are too many", shape_.size(),
                              tint_count_),
                    formatted("at most %zu in all: take a smaller grid or fewer channels", max_table_values));
    mix_values(tables, tints);
    split_off_diffuse();
    make_reflectances();
    make_mean(tints);
}

// By stretches that stay in the cache while every tint of them is written.
void SpectralTable::mix_values(const std::vector<LoadedTable>& tables, const Tints& tints) {
    constexpr std::size_t stretch = 1024;
    std::array<double, stretch> sums;
    lobes_.resize(shape_.size() * tint_count_);
    for (std::size_t start = 0; start < shape_.size(); start += stretch) {
        const std::size_t count = std::min(stretch, shape_.size() - start);
        for (std::size_t tint = 0; tint < tint_count_; ++tint) {
            sums.fill(0);
            for (std::size_t t = 0; t < tables.size(); ++t) {
                const double share = tints.shares[tint][t];
                if (share == 0) continue;
                const auto values = tables[t].table->values().subspan(start, count);
                for (std::size_t n = 0; n < count; ++n) sums[n] += share * static_cast<double>(values[n]);
            }
            float* const first = &lobes_[start * tint_count_ + tint];
            for (std::size_t n = 0; n < count; ++n) first[n * tint_count_] = static_cast<float>(sums[n]);
        }
    }
}

void SpectralTable::split_off_diffuse() {
    const float* const end = lobes_.data() + lobes_.size();
    std::vector<float> constants(lobes_.data(), lobes_.data() + tint_count_);
    for (const float* node = lobes_.data(); node != end; node += tint_count_)
        for (std::size_t t = 0; t < tint_count_; ++t) constants[t] = std::min(constants[t], node[t]);
    for (float* node = lobes_.data(); node != end; node += tint_count_)
        for (std::size_t t = 0; t < tint_count_; ++t) node[t] -= constants[t];
    for (std::size_t c = 0; c < tint_of_.size(); ++c)
        diffuse_.set(static_cast<int>(c),
                     static_cast<float>(pi * static_cast<double>(constants[tint_of_[c]])));
}

void SpectralTable::make_mean(const Tints& tints) {
    const auto channels = static_cast<double>(tint_of_.size());
    std::vector<float> means(shape_.size());
    for (std::size_t n = 0; n < means.size(); ++n) {
        double sum = 0;
        for (std::size_t t = 0; t < tint_count_; ++t)
            sum += tints.channel_count[t] * static_cast<double>(lobes_[n * tint_count_ + t]);
        means[n] = static_cast<float>(sum / channels);
    }
    mean_ = std::make_shared<const BrdfTable>(shape_, std::move(means), 0.0);
}

void SpectralTable::make_reflectances() {
    const double phi_step = 2 * pi / shape_.phi_count;
    const std::vector<double> weights = polar_weights(shape_.theta_i_count);
    reflectance_.resize(static_cast<std::size_t>(shape_.theta_r_count) * tint_count_);
    for (int j = 0; j < shape_.theta_r_count; ++j) {
        double* const sums = &reflectance_[static_cast<std::size_t>(j) * tint_count_];
        for (int i = 0; i < shape_.theta_i_count; ++i)
            for (int k = 0; k < shape_.phi_count; ++k) {
                const float* const node = &lobes_[shape_.index(i, k, j) * tint_count_];
                const double weight = weights[static_cast<std::size_t>(i)] * phi_step;
                for (std::size_t t = 0; t < tint_count_; ++t)
                    sums[t] += weight * static_cast<double>(node[t]);
            }
    }
}

void SpectralTable::lobe_reflectance_dh(double cos_theta_o, Spectrum& reflectance) const {
    const GridPlace j = polar_place(std::acos(std::clamp(cos_theta_o, 0.0, 1.0)), shape_.theta_r_count);
    const double* const near = &reflectance_[static_cast<std::size_t>(j.cell) * tint_count_];
    const double* const far = near + tint_count_;
    for (std::size_t c = 0; c < tint_of_.size(); ++c) {
        const std::size_t t = tint_of_[c];
        reflectance.set(static_cast<int>(c),
                        static_cast<float>((1 - j.fraction) * near[t] + j.fraction * far[t]));
    }
}

void SpectralTable::normalized_lobe(const Vec3& wo, const Vec3& wi, Spectrum& result) const {
    const double theta_o = polar_angle(wo);
    const GridCell cell = shape_.cell(polar_angle(wi), relative_azimuth(wo, wi), theta_o);
    const GridPlace j = polar_place(theta_o, shape_.theta_r_count);
    const double* const near = &reflectance_[static_cast<std::size_t>(j.cell) * tint_count_];
    const double* const far = near + tint_count_;

    std::array<double, Spectrum::max_channels> lobe;
    std::fill_n(lobe.begin(), tint_count_, 0.0);
    for (int corner = 0; corner < 4; ++corner) {
        const double row_share = ((corner & 1) ? cell.i_fraction : 1 - cell.i_fraction) *
                                 ((corner & 2) ? cell.j_fraction : 1 - cell.j_fraction);
        const float* const at_k0 = &lobes_[(cell.row[corner] + cell.k0) * tint_count_];
        const float* const at_k1 = &lobes_[(cell.row[corner] + cell.k1) * tint_count_];
        const double share0 = row_share * (1 - cell.k_fraction), share1 = row_share * cell.k_fraction;
        for (std::size_t t = 0; t < tint_count_; ++t)
            lobe[t] += share0 * static_cast<double>(at_k0[t]) + share1 * static_cast<double>(at_k1[t]);
    }
    for (std::size_t t = 0; t < tint_count_; ++t) {
        const double reflectance = (1 - j.fraction) * near[t] + j.fraction * far[t];
        lobe[t] = reflectance > 0 ? lobe[t] / reflectance : 0;
    }
    for (std::size_t c = 0; c < tint_of_.size(); ++c)
        result.set(static_cast<int>(c), static_cast<float>(lobe[tint_of_[c]]));
}

}  // namespace infra
