// How many photons an estimate should take: few leave noise, many blur what changes nearby.
//
// Estimates from one up to the fewest photons allowed give a mean and a variance. Then the count is sought by
// halves: an estimate from more photons that differs from the mean by no more than noise would is taken, and
// joins it; one that differs by more is biased, and fewer photons are tried.
//
// source: Schregle, "Bias Compensation for Photon Maps", Computer Graphics Forum 22 (2003); weights as
// measured from RADIANCE 6.1.
#pragma once

#include <cmath>
#include <cstddef>

#include "common/random.h"
#include "rt/photons/photon_density.h"

namespace infra {

class BiasCompensation {
  public:
    /// An estimate from so many photons.
    void add(std::size_t count, const PhotonColor& estimate) {
        const double weight = static_cast<double>(count) * static_cast<double>(count);
        weight_ += weight;
        for (std::size_t c = 0; c < 3; ++c) {
            sum_[c] += weight * estimate[c];
            squares_[c] += weight * estimate[c] * estimate[c];
        }
        last_ = estimate;
    }

    /// The estimate to use, after one has been added for each count up to `fewest`.
    ///   estimate(count)  from the nearest `count` photons
    template <class Estimator>
    PhotonColor choose(std::size_t fewest, std::size_t most, const Estimator& estimate,
                       RandomStream& random) {
        while (most - fewest > 1) {
            const std::size_t middle = (fewest + most) / 2;
            const PhotonColor more = estimate(middle);
            if (random.uniform() < chance_of_noise(more)) {
                add(middle, more);
                fewest = middle;
            } else {
                most = middle;
            }
        }
        return last_;
    }

  private:
    /// Mean over the colours of the chance, by a normal distribution, that noise makes a difference as large.
    double chance_of_noise(const PhotonColor& estimate) const {
        double chance = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean = sum_[c] / weight_;
            const double variance = squares_[c] / weight_ - mean * mean;
            const double difference = estimate[c] - mean;
            if (difference == 0)
                chance += 1;
            else if (variance > 0)
                chance += std::exp(-0.5 * difference * difference / variance);
        }
        return chance / 3;
    }

    double weight_ = 0;
    PhotonColor sum_{0, 0, 0}, squares_{0, 0, 0}, last_{0, 0, 0};
};

}  // namespace infra
