#include "bsdf/matrix_table.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

namespace infra {

MatrixTable::MatrixTable(ScatterSides sides, std::shared_ptr<const AngleBasis> in,
                         std::shared_ptr<const AngleBasis> out, MatrixValues values, bool serves_other_side)
    : ScatterTable(sides),
      in_(std::move(in)),
      out_(std::move(out)),
      in_count_(static_cast<std::size_t>(in_->patch_count())),
      values_(std::move(values)) {
    colored_ = !values_.x.empty();
    take_out_lambertian();
    forward_ = sum_up(false);
    if (serves_other_side) backward_ = sum_up(true);
    for (int i = 0; i < in_->patch_count(); ++i) largest_total_ = std::max(largest_total_, forward_.total(i));
    least_projected_solid_angle_ = std::numbers::pi;
    for (const AngleBasis* basis : {in_.get(), out_.get()})
        for (int patch = 0; patch < basis->patch_count(); ++patch)
            least_projected_solid_angle_ =
                std::min(least_projected_solid_angle_, basis->projected_solid_angle(patch));
}

// The largest constant, in each of three sensors, that fits under the table.
void MatrixTable::take_out_lambertian() {
    const std::size_t count = values_.y.size();
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    for (std::size_t n = 0; n < count; ++n)
        least = glm::min(least, colored_ ? sharp_of_xyz({values_.x[n], values_.y[n], values_.z[n]})
                                         : glm::dvec3(values_.y[n]));
    const Xyz constant = colored_ ? xyz_of_sharp(least) : least;
    if (!(std::numbers::pi * constant.y > least_lambertian)) return;
    lambertian_ = std::numbers::pi * constant;
    const auto subtract = [](std::vector<float>& from, double amount) {
        for (float& value : from) value = std::max(0.0f, value - static_cast<float>(amount));
    };
    subtract(values_.x, constant.x);
    subtract(values_.y, constant.y);
    subtract(values_.z, constant.z);
}

MatrixTable::Distribution MatrixTable::sum_up(bool from_other_side) const {
    const AngleBasis& from = from_other_side ? *out_ : *in_;
    const AngleBasis& to = from_other_side ? *in_ : *out_;
    Distribution result;
    result.choices = static_cast<std::size_t>(to.patch_count());
    result.cumulative.reserve(values_.y.size());
    for (int i = 0; i < from.patch_count(); ++i) {
        double sum = 0;
        for (int o = 0; o < to.patch_count(); ++o) {
            const std::size_t n = from_other_side ? cell({o, i}) : cell({i, o});
            sum += values_.y[n] * to.projected_solid_angle(o);
            result.cumulative.push_back(static_cast<float>(sum));
        }
    }
    return result;
}

// Incident directions are counted by where the light goes on to: with the azimuth turned around.
int MatrixTable::in_patch(const Vec3& d) const {
    return in_->patch_of({-d.x, -d.y, sides_.from_front ? d.z : -d.z});
}

int MatrixTable::out_patch(const Vec3& d) const {
    return out_->patch_of({d.x, d.y, sides_.to_front() ? d.z : -d.z});
}

MatrixTable::Pair MatrixTable::patches(const Vec3& in, const Vec3& out) const {
    const Pair pair{in_patch(in), out_patch(out)};
    return pair.in < 0 && pair.out < 0 ? Pair{in_patch(out), out_patch(in)} : pair;
}

ScatterEntry MatrixTable::entry(const Vec3& in, const Vec3& out) const {
    const Pair pair = patches(in, out);
    if (!pair.valid()) return {};
    const std::size_t n = cell(pair);
    return {n, values_.y[n],
            std::min(in_->projected_solid_angle(pair.in), out_->projected_solid_angle(pair.out))};
}

Xyz MatrixTable::color(const Vec3& in, const Vec3& out) const {
    const Pair pair = patches(in, out);
    if (!pair.valid()) return Xyz(0);
    const std::size_t n = cell(pair);
    return {values_.x[n], values_.y[n], values_.z[n]};
}

ResolutionRange MatrixTable::resolution(const Vec3& in) const {
    const int as_in = in_patch(in), as_out = out_patch(in);
    if (as_in < 0 && as_out < 0) return {std::numbers::pi, std::numbers::pi};
    const double a = as_in >= 0 ? in_->projected_solid_angle(as_in) : out_->projected_solid_angle(as_out);
    const double b = as_out >= 0 ? out_->projected_solid_angle(as_out) : a;
    return {std::min(a, b), std::max(a, b)};
}

double MatrixTable::total(const Vec3& in) const {
    if (const int patch = in_patch(in); patch >= 0) return forward_.total(patch);
    const int patch = backward_.choices > 0 ? out_patch(in) : -1;
    return patch >= 0 ? backward_.total(patch) : 0.0;
}

Vec3 MatrixTable::sample(const Vec3& in, double choice, double u, double v) const {
    const int as_in = in_patch(in);
    const bool forward = as_in >= 0;
    const int patch = forward ? as_in : out_patch(in);
    const Distribution& sums = forward ? forward_ : backward_;
    const auto first = sums.cumulative.begin() + patch * static_cast<std::ptrdiff_t>(sums.choices);
    const auto last = first + static_cast<std::ptrdiff_t>(sums.choices) - 1;
    const auto found = std::upper_bound(first, last, static_cast<float>(choice * *last));
    const int chosen = static_cast<int>(found - first);
    const Vec3 d = (forward ? *out_ : *in_).direction(chosen, u, v);
    const bool to_front = forward ? sides_.to_front() : sides_.from_front;
    const double turned = forward ? 1 : -1;
    return {turned * d.x, turned * d.y, to_front ? d.z : -d.z};
}

}  // namespace infra
