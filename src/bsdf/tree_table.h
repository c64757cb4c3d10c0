// A BSDF table of variable resolution: a tensor tree over pairs of directions, each the point of the unit
// square that its projection to the unit disk maps to (disk_square.h).
//
// Rank 4: the incident direction, turned around, and the outgoing one. Rank 3, the same all around the
// normal: half the incident direction's distance from the rim of the disk, and the outgoing direction in a
// frame whose x lies where the incident light is heading.
#pragma once

#include <optional>

#include "bsdf/scatter_table.h"
#include "bsdf/slice_set.h"
#include "bsdf/tensor_tree.h"

namespace infra {

/// The numbers of a file: f [1/sr], and for a coloured table chromaticities u', v'.
struct TreeValues {
    TensorTree y;
    std::optional<TensorTree> u, v;
};

class TreeTable final : public ScatterTable {
  public:
    /// Takes the Lambertian part out of the values, which must be finite and not negative.
    ///   serves_other_side  a table of transmission is sampled for light from its other side too: of rank 4
    ///                      only, as in RADIANCE; one of rank 3 has nothing to sample from there
    ///   throws             Error for a tree too detailed to be sampled
    TreeTable(ScatterSides sides, TreeValues values, bool serves_other_side);

    ScatterEntry entry(const Vec3& in, const Vec3& out) const override;
    Xyz color(const Vec3& in, const Vec3& out) const override;
    ResolutionRange resolution(const Vec3& in) const override;
    double total(const Vec3& in) const override;
    Vec3 sample(const Vec3& in, double choice, double u, double v) const override;

  private:
    struct Found {
        const SliceSet* set = nullptr;  ///< nullptr: nothing from this side
        const SliceSet::Slice* slice = nullptr;
        bool forward = true;
    };
    bool isotropic() const { return values_.y.rank() == 3; }
    bool place(const Vec3& in, const Vec3& out, TreePoint& at) const;
    Found find(const Vec3& in) const;
    void take_out_lambertian();
    double least_value() const;
    Xyz least_color() const;
    bool is_used(const TreePoint& corner) const { return !isotropic() || corner[0] < 0.5; }

    TreeValues values_;
    Xyz constant_{0};  ///< that has been taken out: lambertian() / pi
    std::optional<SliceSet> forward_, backward_;
};

}  // namespace infra
