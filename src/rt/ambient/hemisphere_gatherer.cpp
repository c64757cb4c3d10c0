#include "rt/ambient/hemisphere_gatherer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "rt/ambient/cosine_direction.h"
#include "rt/ambient/walls.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr int fewest_divisions = 7;   // along a side; fewer say nothing about change
constexpr int most_divisions = 1024;  // a hemisphere then takes 170 MB
/// Share of the radiance that a value's spacing takes as the same in all directions: distances alone count
/// for it.
constexpr double even_share = 0.01;

double fraction(double x) { return x - std::floor(x); }

/// Name of the random stream of a place.
std::uint64_t name_of(const Vec3& point, int level) {
    std::uint64_t name = static_cast<std::uint64_t>(level);
    for (int i = 0; i < 3; ++i)
        name = (name ^ std::bit_cast<std::uint64_t>(point[i])) * 0x9e3779b97f4a7c15u + (name >> 29);
    return name;
}

/// Values count as much as rays of this weight, unless the ray that asks is much lighter, or has been made
/// heavier by roulette.
double value_weight(const IrradiancePlace& place) {
    const double usual = std::pow(HemisphereGatherer::assumed_reflectance, place.level);
    return place.weight < 0.1 * usual ? 1.25 * place.weight : std::max(usual, place.weight);
}

}  // namespace

HemisphereGatherer::HemisphereGatherer(Tracer& tracer, Interaction& at, const IrradiancePlace& place,
                                       std::uint16_t kind)
    : tracer_(tracer),
      at_(at),
      place_(place),
      kind_(kind),
      weight_(value_weight(place)),
      others_(tracer.random_),
      spreads_(tracer.spreads_) {
    make_frame(place.normal, u_, v_);
    divisions_ = std::clamp(static_cast<int>(std::sqrt(tracer.settings_.ambient_divisions * weight_) + 0.5),
                            fewest_divisions, most_divisions);
    const auto level = static_cast<std::size_t>(place.level);
    auto& views = tracer_.scratch_->views;
    if (views.size() <= level) views.resize(level + 1);
    view_ = std::move(views[level]);  // its memory; deeper levels may move the list
    tracer_.random_ = RandomStream(tracer.seed_, name_of(place.point, place.level));
    tracer_.spreads_ = false;
    if (tracer.guide_) guided_.emplace(tracer, at_, kind, weight_);
}

HemisphereGatherer::~HemisphereGatherer() {
    tracer_.random_ = others_;
    tracer_.spreads_ = spreads_;
    tracer_.scratch_->views[static_cast<std::size_t>(place_.level)] = std::move(view_);
}

HemisphereGatherer::Outcome HemisphereGatherer::gather(const CacheLimits& limits, IrradianceValue& value) {
    const int cell_count = divisions_ * divisions_;
    view_.cells.assign(static_cast<std::size_t>(cell_count), HemisphereCell{Spectrum(at_.channels())});
    view_.corners.assign(static_cast<std::size_t>(cell_count), MeshCorner{Vec3(0), 0, 0});
    const int traced = trace_grid();
    if (traced == 0) return Outcome::nothing;
    if (traced == cell_count) trace_more();
    value.radiance.clear();
    for (const HemisphereCell& cell : view_.cells) value.radiance += cell.mean;
    value.radiance *= 1.0f / static_cast<float>(cell_count);
    if (guided_) trace_guided(value.radiance);
    if (traced < cell_count) return Outcome::value_only;
    value.point = place_.point;
    value.normal = place_.normal;
    value.level = place_.level;
    value.weight = weight_;
    describe_change(limits, value);
    return Outcome::complete;
}

bool HemisphereGatherer::may_trace() {
    const Spectrum assumed(at_.channels(), static_cast<float>(assumed_reflectance));
    Ray child(at_.channels());
    return tracer_.spawn(child, kind_, at_, &assumed);
}

// One ray through a point of the unit square; the first of a cell is a corner of the mesh.
bool HemisphereGatherer::trace(int cell, double x, double y, bool first, Spectrum& radiance) {
    const Spectrum assumed(at_.channels(), static_cast<float>(assumed_reflectance));
    Ray child(at_.channels());
    if (!tracer_.spawn(child, kind_, at_, &assumed)) return false;
    child.ambient_level = place_.level + 1;
    const Vec3 local = cosine_direction(x, y);
    child.direction = u_ * local.x + v_ * local.y + place_.normal * local.z;
    child.coefficient.fill(1.0f / static_cast<float>(divisions_ * divisions_));
    Interaction seen(child);
    tracer_.trace(seen);
    radiance = seen.radiance;
    if (guided_) {
        const double others = divisions_ * divisions_ * local.z * std::numbers::inv_pi;
        radiance *= static_cast<float>(guided_->weight_of_others(child.direction, others));
    }
    const double distance = seen.apparent_distance();
    if (!(distance > tiny)) return false;
    MeshCorner& corner = view_.corners[static_cast<std::size_t>(cell)];
    corner.nearness = std::max(corner.nearness, 1 / distance);
    if (first) corner.place = local * distance;
    return true;
}

// A ray through each cell. Offsets within the cells follow a lattice with a random start: each is uniform,
// and neighbours keep at least 0.4 of a cell's width apart, so that no edge of the mesh is too short to
// trust.
int HemisphereGatherer::trace_grid() {
    constexpr double x_step[2] = {0.7320508, 0.4142136}, y_step[2] = {0.3247180, 0.6180340};
    const double x_start = tracer_.random_.uniform(), y_start = tracer_.random_.uniform();
    int traced = 0;
    for (int i = 0; i < divisions_; ++i)
        for (int j = 0; j < divisions_; ++j) {
            const int cell = i * divisions_ + j;
            const double x = (i + fraction(x_start + i * x_step[0] + j * x_step[1])) / divisions_;
            const double y = (j + fraction(y_start + i * y_step[0] + j * y_step[1])) / divisions_;
            HemisphereCell& c = view_.cells[static_cast<std::size_t>(cell)];
            if (!trace(cell, x, y, true, c.mean)) continue;
            c.brightness = c.mean.brightness();
            ++traced;
        }
    return traced;
}

// Extra rays where neighbouring cells differ most.
void HemisphereGatherer::trace_more() {
    int extra = static_cast<int>(
        std::min<double>(tracer_.settings_.ambient_super_samples * weight_ + 0.5, most_samples));
    if (extra < 4 * divisions_ || divisions_ <= fewest_divisions) return;
    double brightness = 0;
    for (const HemisphereCell& cell : view_.cells) brightness += static_cast<double>(cell.brightness);
    estimate_variances(view_.cells, divisions_, 1 / (brightness / (divisions_ * divisions_) + tiny));
    double remaining = 0;
    for (const HemisphereCell& cell : view_.cells) remaining += static_cast<double>(cell.variance);
    Spectrum radiance(at_.channels());
    for (int c = 0; c < divisions_ * divisions_ && extra > 0 && remaining > tiny; ++c) {
        HemisphereCell& cell = view_.cells[static_cast<std::size_t>(c)];
        const double share = static_cast<double>(cell.variance) / remaining;
        const int wanted = static_cast<int>(share * extra + tracer_.random_.uniform());
        remaining -= static_cast<double>(cell.variance);
        for (int k = 1; k <= wanted && extra > 0; ++k, --extra) {
            const double x = (c / divisions_ + tracer_.random_.uniform()) / divisions_;
            const double y = (c % divisions_ + tracer_.random_.uniform()) / divisions_;
            if (!trace(c, x, y, false, radiance)) break;
            cell.mean *= static_cast<float>(k) / static_cast<float>(k + 1);
            cell.mean.add_scaled(radiance, 1.0f / static_cast<float>(k + 1));
        }
    }
}

// Rays to where it is bright. What they add is taken for the same all around the place.
void HemisphereGatherer::trace_guided(Spectrum& sum) {
    Spectrum radiance(at_.channels());
    for (int i = 0; i < guided_->count(); ++i) {
        const Vec3 wi = guided_->draw(i);
        const double density = dot(wi, place_.normal) * std::numbers::inv_pi;
        if (!(density > 0)) continue;
        const double share = density / guided_->total(wi, divisions_ * divisions_ * density);
        const Spectrum assumed(at_.channels(), static_cast<float>(assumed_reflectance * share));
        if (tracer_.trace_guided(kind_, assumed, wi, at_, radiance))
            sum.add_scaled(radiance, static_cast<float>(1 / assumed_reflectance));
    }
}

// Gradients and radii: where irradiance bends, values lie closer.
void HemisphereGatherer::describe_change(const CacheLimits& limits, IrradianceValue& value) {
    const double mean = static_cast<double>(value.radiance.mean());
    const bool dark = mean <= tiny;
    for (std::size_t c = 0; c < view_.corners.size(); ++c) {
        MeshCorner& corner = view_.corners[c];
        corner.value = dark ? 0.0 : static_cast<double>(view_.cells[c].mean.mean()) / mean;
        const double distance = length(corner.place);
        if (distance > limits.farthest) corner.place *= limits.farthest / distance;
    }
    const MeshDerivatives mesh = mesh_derivatives(divisions_, view_.corners);
    ShareDerivatives second;
    if (!dark) {
        second.add(mesh.inner, 1 - even_share);
        second.add(mesh.rim, 1 - even_share);
    }
    second.add(mesh.shape, dark ? 1 : even_share);
    const Bend turned = bend(second);
    value.axis = u_ * turned.cosine + v_ * turned.sine;
    const double x = mesh.inner.x + mesh.skirt.x, y = mesh.inner.y + mesh.skirt.y;
    value.gradient[0] = x * turned.cosine + y * turned.sine;
    value.gradient[1] = y * turned.cosine - x * turned.sine;
    value.radius[0] = limits.radius_for(turned.strongest);
    value.radius[1] = limits.radius_for(turned.weakest);
    if (!dark)
        for (int i = 0; i < 2; ++i) {
            const double slope = std::fabs(value.gradient[i]);
            if (value.radius[i] * slope > 1) value.radius[i] = 1 / slope;
        }
    limits.confine(value);
    if (dark) return;
    turn_gradient(value);
    value.walls = near_walls(view_.corners, divisions_, Vec3(turned.cosine, turned.sine, 0), limits, value);
    const double change =
        std::hypot(value.gradient[0] * value.radius[0], value.gradient[1] * value.radius[1]);
    if (change > 1)
        for (double& g : value.gradient) g /= change;
}

// When the normal turns about an axis a, a ray's cosine changes by a . (n x wi). Light that is the same from
// everywhere adds nothing, and is left out for the sake of noise.
void HemisphereGatherer::turn_gradient(IrradianceValue& value) const {
    double x = 0, y = 0;  // about u, about v
    for (const MeshCorner& corner : view_.corners) {
        const double factor = (corner.value - 1) / corner.place.z;
        x -= factor * corner.place.y;
        y += factor * corner.place.x;
    }
    const double cosine = dot(value.axis, u_), sine = dot(value.axis, v_);
    const double count = static_cast<double>(view_.corners.size());
    value.turn[0] = (x * cosine + y * sine) / count;
    value.turn[1] = (y * cosine - x * sine) / count;
}

}  // namespace infra
