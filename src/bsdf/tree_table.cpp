#include "bsdf/tree_table.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

namespace infra {
namespace {

constexpr double rim = 1e-6;  // keeps rank 3's first coordinate below one half
/// A constant of more than this [1/sr] is no Lambertian part, it cannot be.
constexpr double greatest_constant = 1.5 * std::numbers::inv_pi;

double radius(const Vec3& d) { return std::min(1.0, std::sqrt(d.x * d.x + d.y * d.y)); }

double isotropic_coordinate(const Vec3& in) { return std::max(0.0, 0.5 - rim - 0.5 * radius(in)); }

/// Cosine and sine of the azimuth that incident light is heading for.
Point2 heading(const Vec3& in) {
    const double r = std::sqrt(in.x * in.x + in.y * in.y);
    return r > 0 ? Point2{-in.x / r, -in.y / r} : Point2{1, 0};
}

}  // namespace

TreeTable::TreeTable(ScatterSides sides, TreeValues values, bool serves_other_side)
    : ScatterTable(sides), values_(std::move(values)) {
    colored_ = values_.u && values_.v;
    take_out_lambertian();
    forward_.emplace(values_.y, false);
    if (serves_other_side && !isotropic()) backward_.emplace(values_.y, true);
    largest_total_ = forward_->largest_total();
    const double width = forward_->least_width();
    least_projected_solid_angle_ = std::numbers::pi * width * width;
}

void TreeTable::take_out_lambertian() {
    const Xyz constant = colored_ ? least_color() : Xyz(least_value());
    const double least = least_lambertian * std::numbers::inv_pi;
    if (!(constant.y > least) || (!colored_ && constant.y >= greatest_constant)) return;
    constant_ = constant;
    lambertian_ = std::numbers::pi * constant;
    values_.y.subtract(static_cast<float>(constant.y));
}

double TreeTable::least_value() const {
    double least = std::numeric_limits<double>::infinity();
    values_.y.visit_cells([&](const TreePoint& corner, double, std::size_t n) {
        if (is_used(corner)) least = std::min<double>(least, values_.y.value(n));
    });
    return least;
}

// In each of three sensors, at the middle of each cell.
Xyz TreeTable::least_color() const {
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    values_.y.visit_cells([&](const TreePoint& corner, double width, std::size_t n) {
        if (!is_used(corner)) return;
        TreePoint middle = corner;
        for (double& coordinate : middle) coordinate += 0.5 * width;
        if (isotropic()) middle[0] = std::min(middle[0], 0.5 - rim);
        least = glm::min(least, sharp_of_xyz(xyz_of_yuv(values_.y.value(n), values_.u->value_at(middle),
                                                        values_.v->value_at(middle))));
    });
    return xyz_of_sharp(least);
}

// Where a pair stands in the tree; by reciprocity for one that meets a transmitting table from its other
// side. False for a pair that is not of this table.
bool TreeTable::place(const Vec3& in, const Vec3& out, TreePoint& at) const {
    const auto on = [](const Vec3& d, bool front) { return front ? d.z >= 0 : d.z <= 0; };
    const Vec3 *from = &in, *to = &out;
    if (sides_.transmits && !on(in, sides_.from_front)) std::swap(from, to);
    if (!on(*from, sides_.from_front) || !on(*to, sides_.to_front())) return false;
    if (isotropic()) {
        const auto [c, s] = heading(*from);
        const Point2 b = square_of_disk({c * to->x + s * to->y, c * to->y - s * to->x});
        at = {isotropic_coordinate(*from), b[0], b[1], 0};
    } else {
        const Point2 a = square_of_disk({-from->x, -from->y}), b = square_of_disk({to->x, to->y});
        at = {a[0], a[1], b[0], b[1]};
    }
    return true;
}

ScatterEntry TreeTable::entry(const Vec3& in, const Vec3& out) const {
    TreePoint at;
    if (!place(in, out, at)) return {};
    const TensorTree::Cell cell = values_.y.cell_at(at);
    return {cell.index, values_.y.value(cell.index), std::numbers::pi * cell.width * cell.width};
}

Xyz TreeTable::color(const Vec3& in, const Vec3& out) const {
    TreePoint at;
    if (!place(in, out, at)) return Xyz(0);
    const double above = values_.y.value_at(at);
    const Xyz whole =
        xyz_of_yuv(above + constant_.y, values_.u->value_at(at), values_.v->value_at(at)) - constant_;
    const Xyz color = xyz_of_sharp(glm::max(sharp_of_xyz(whole), glm::dvec3(1e-5 * above)));
    return color.y > 0 ? color * (above / color.y) : Xyz(0);
}

TreeTable::Found TreeTable::find(const Vec3& in) const {
    const bool forward = sides_.from_front ? in.z >= 0 : in.z <= 0;
    if (!forward && (!sides_.transmits || !backward_)) return {};
    const SliceSet& set = forward ? *forward_ : *backward_;
    const double sign = forward ? -1 : 1;
    const Point2 incident =
        isotropic() ? Point2{isotropic_coordinate(in), 0} : square_of_disk({sign * in.x, sign * in.y});
    return {&set, &set.slice_at(incident), forward};
}

ResolutionRange TreeTable::resolution(const Vec3& in) const {
    const Found found = find(in);
    if (!found.slice) return {std::numbers::pi, std::numbers::pi};
    const auto area = [](double width) { return std::numbers::pi * width * width; };
    return {area(found.slice->least_width), area(found.slice->largest_width)};
}

double TreeTable::total(const Vec3& in) const {
    const Found found = find(in);
    return found.slice ? found.slice->total : 0.0;
}

Vec3 TreeTable::sample(const Vec3& in, double choice, double u, double v) const {
    const Found found = find(in);
    const SliceSet::Square square = found.set->choose(*found.slice, choice);
    const Point2 disk =
        disk_of_square({square.corner[0] + u * square.width, square.corner[1] + v * square.width});
    double x = disk[0], y = disk[1];
    const double height = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    if (isotropic()) {
        const auto [c, s] = heading(in);
        x = c * disk[0] - s * disk[1];
        y = s * disk[0] + c * disk[1];
    }
    const bool to_front = found.forward ? sides_.to_front() : sides_.from_front;
    return {x, y, to_front ? height : -height};
}

}  // namespace infra
