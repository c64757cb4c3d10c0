// A BSDF table that is constant over the patches of two angle bases.
#pragma once

#include <memory>
#include <vector>

#include "bsdf/angle_basis.h"
#include "bsdf/scatter_table.h"

namespace infra {

/// The numbers of a file: f [1/sr] at [out patch * in patches + in patch].
struct MatrixValues {
    std::vector<float> y;
    std::vector<float> x, z;  ///< the other tristimulus values, both as many as y or none
};

class MatrixTable final : public ScatterTable {
  public:
    /// Takes the Lambertian part out of the values, which must be finite and not negative.
    ///   serves_other_side  a table of transmission is sampled for light from its other side too
    MatrixTable(ScatterSides sides, std::shared_ptr<const AngleBasis> in,
                std::shared_ptr<const AngleBasis> out, MatrixValues values, bool serves_other_side);

    ScatterEntry entry(const Vec3& in, const Vec3& out) const override;
    Xyz color(const Vec3& in, const Vec3& out) const override;
    ResolutionRange resolution(const Vec3& in) const override;
    double total(const Vec3& in) const override;
    Vec3 sample(const Vec3& in, double choice, double u, double v) const override;

  private:
    /// Sums over the patches of one basis, by patch of the other.
    struct Distribution {
        std::vector<float> cumulative;  ///< [patch * choices + choice]: of value times projected solid angle
        std::size_t choices = 0;
        double total(int patch) const {
            return cumulative[(static_cast<std::size_t>(patch) + 1) * choices - 1];
        }
    };
    struct Pair {
        int in = -1, out = -1;
        bool valid() const { return in >= 0 && out >= 0; }
    };

    int in_patch(const Vec3& d) const;
    int out_patch(const Vec3& d) const;
    Pair patches(const Vec3& in, const Vec3& out) const;
    std::size_t cell(Pair pair) const {
        return static_cast<std::size_t>(pair.out) * in_count_ + static_cast<std::size_t>(pair.in);
    }
    void take_out_lambertian();
    Distribution sum_up(bool from_other_side) const;

    std::shared_ptr<const AngleBasis> in_, out_;
    std::size_t in_count_;
    MatrixValues values_;
    Distribution forward_, backward_;
};

}  // namespace infra
