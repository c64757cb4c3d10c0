// Diffuse interreflection: a hemisphere of rays over every point, stratified in equal projected solid angles.
// (There is no cache of such values yet: this is RADIANCE with -aa 0.)
//
// source: Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2 (1997); numbers of rays as
// RADIANCE 6.1.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/scratch.h"
#include "rt/tracer.h"

namespace infra {
namespace {

constexpr double tiny = 1e-6;
constexpr int most_divisions = 4096;       // along a side: a hemisphere then has most_samples rays
constexpr int least_cells_for_extra = 49;  // fewer rays say too little of where the differences are

/// sin and cos of an angle within pi/4 of 0, to 1e-11: their Taylor series.
void small_sin_cos(double t, double& s, double& c) {
    const double q = t * t;
    s = t * (1 + q * (-1.0 / 6 +
                      q * (1.0 / 120 + q * (-1.0 / 5040 + q * (1.0 / 362880 - q * (1.0 / 39916800))))));
    c = 1 + q * (-1.0 / 2 +
                 q * (1.0 / 24 +
                      q * (-1.0 / 720 + q * (1.0 / 40320 + q * (-1.0 / 3628800 + q * (1.0 / 479001600))))));
}

/// Direction of the hemisphere around z for a point of the unit square, with density cos / pi.
Vec3 cosine_direction(double x, double y) {
    const double a = 2 * x - 1, b = 2 * y - 1;
    if (a == 0 && b == 0) return {0, 0, 1};
    const bool wide = std::fabs(a) > std::fabs(b);
    const double radius = wide ? a : b;
    double s, c;
    small_sin_cos((std::numbers::pi / 4) * (wide ? b / a : a / b), s, c);
    const double height = std::sqrt(std::fmax(0.0, 1 - radius * radius));
    return wide ? Vec3{radius * c, radius * s, height} : Vec3{radius * s, radius * c, height};
}

/// Where a cell's neighbours differ from it its value is uncertain: squared differences, relative to
/// brightness.
void estimate_variances(std::vector<HemisphereCell>& cells, int n, double norm) {
    const auto cell = [&](int i, int j) -> HemisphereCell& {
        return cells[static_cast<std::size_t>(i * n + j)];
    };
    const auto compare = [&](int i, int j, int k, int l) {
        HemisphereCell &a = cell(i, j), &b = cell(k, l);
        const double difference = a.brightness - b.brightness;
        const double squared = difference * difference * norm / (a.brightness + b.brightness + tiny);
        a.variance += static_cast<float>(squared);
        b.variance += static_cast<float>(squared);
        ++a.neighbours;
        ++b.neighbours;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i) compare(i, j, i - 1, j);
            if (j) compare(i, j, i, j - 1);
            if (i && j) compare(i, j, i - 1, j - 1);
        }
    for (HemisphereCell& c : cells)  // as if all had the six that inner cells have
        if (c.neighbours) c.variance *= 6.0f / static_cast<float>(c.neighbours);
}

}  // namespace

/// The rays of one hemisphere: where they go and what each brings.
struct Tracer::Hemisphere {
    std::uint16_t kind;
    Vec3 normal, u, v;  ///< frame around the normal with its textures
    Vec3 surface_normal;
    bool tilted;
    int divisions;   ///< along each side of the square
    Spectrum share;  ///< coefficient of one ray
    Ray ray;         ///< each of them but for its direction
    bool steady;     ///< all rays are heavy enough to be traced, so that `ray` serves for all
};

void Tracer::add_ambient(const Spectrum& coefficient, const Vec3& normal, bool other_side, Interaction& at) {
    if (coefficient.maximum() <= 0) return;
    const bool computed = settings_.ambient_divisions > 0 &&
                          at.ray->ambient_level < settings_.ambient_bounces &&
                          (at.surface < 0 || scene_.finish(at.surface).in_ambient);
    if (computed) {
        Hemisphere half{other_side ? through_ambient : reflected_ambient,
                        normal,
                        Vec3{0},
                        Vec3{0},
                        other_side ? -at.normal : at.normal,
                        at.textured(),
                        1,
                        coefficient,
                        Ray(at.channels()),
                        false};
        make_frame(normal, half.u, half.v);
        Spectrum sum(at.channels());
        if (sample_hemisphere(half, at, sum)) {
            at.radiance += sum;
            return;
        }
    }
    at.radiance.add_product(scene_.ambient_value(), coefficient);
}

bool Tracer::spawn_ambient(Hemisphere& half, const Interaction& at) {
    if (!spawn(half.ray, half.kind, at, &half.share)) return false;
    half.ray.ambient_level = at.ray->ambient_level + 1;
    return true;
}

// One ray through a point of the unit square that maps to the hemisphere. False if it was not traced.
bool Tracer::trace_ambient(Hemisphere& half, double x, double y, Interaction& at, Spectrum& radiance) {
    if (!half.steady && !spawn_ambient(half, at)) return false;
    Ray& child = half.ray;
    const Vec3 local = cosine_direction(x, y);
    child.direction = half.u * local.x + half.v * local.y + half.normal * local.z;
    if (half.tilted) {  // by a texture: what falls below the surface is turned back
        const double height = dot(child.direction, half.surface_normal);
        if (height < 0) child.direction -= half.surface_normal * (2.0 * height);
    }
    Interaction seen(child);
    trace(seen);
    radiance = seen.radiance * child.coefficient;
    return true;
}

// Adds up coefficient times the mean radiance of the hemisphere. False if no ray was heavy enough to be
// traced.
bool Tracer::sample_hemisphere(Hemisphere& half, Interaction& at, Spectrum& sum) {
    const double reflectance = half.share.maximum();
    if (reflectance <= tiny) return false;
    // No more rays than leave each of them above -lw
    const double heaviest =
        0.8 * reflectance * at.weight / (settings_.ambient_divisions * settings_.min_weight + 1e-20);
    const double weight = std::fmin(at.weight, heaviest);
    half.divisions = std::clamp(static_cast<int>(std::sqrt(settings_.ambient_divisions * weight) + 0.5), 1,
                                most_divisions);
    const int cell_count = half.divisions * half.divisions;
    half.share *= 1.0f / static_cast<float>(cell_count);
    const double ray_weight = at.weight * half.share.maximum();
    half.steady = ray_weight > settings_.min_weight && half.share.maximum() <= 1;
    if (half.steady && !spawn_ambient(half, at)) return false;

    const int extra =
        static_cast<int>(std::min<double>(settings_.ambient_super_samples * weight + 0.5, most_samples));
    if (extra >= 4 * half.divisions && cell_count > least_cells_for_extra)
        return sample_adaptively(half, extra, at, sum);

    Spectrum radiance(at.channels());
    int traced = 0;
    for (int cell = 0; cell < cell_count; ++cell)
        if (sample_cell(half, cell, at, radiance)) {
            sum += radiance;
            ++traced;
        }
    return traced > 0;
}

// One ray through a random place of a cell.
bool Tracer::sample_cell(Hemisphere& half, int cell, Interaction& at, Spectrum& radiance) {
    const int n = half.divisions;
    const double x = (cell / n + random_.uniform()) / n;
    const double y = (cell % n + random_.uniform()) / n;
    return trace_ambient(half, x, y, at, radiance);
}

// A ray through each cell, then `extra` rays where neighbouring cells differ most.
bool Tracer::sample_adaptively(Hemisphere& half, int extra, Interaction& at, Spectrum& sum) {
    const auto level = static_cast<std::size_t>(at.ray->ambient_level);
    if (scratch_->hemispheres.size() <= level) scratch_->hemispheres.resize(level + 1);
    std::vector<HemisphereCell> cells = std::move(scratch_->hemispheres[level]);
    const int cell_count = half.divisions * half.divisions;
    cells.assign(static_cast<std::size_t>(cell_count), HemisphereCell{Spectrum(at.channels())});
    int traced = 0;
    for (int c = 0; c < cell_count; ++c) {
        HemisphereCell& cell = cells[static_cast<std::size_t>(c)];
        if (!sample_cell(half, c, at, cell.mean)) continue;
        cell.brightness = cell.mean.brightness();
        ++traced;
    }
    if (traced == cell_count) {
        estimate_variances(cells, half.divisions, 1.0 / (half.share.brightness() + tiny));
        double remaining = 0;
        for (const HemisphereCell& cell : cells) remaining += cell.variance;
        Spectrum radiance(at.channels());
        for (int c = 0; c < cell_count && extra > 0 && remaining > tiny; ++c) {
            HemisphereCell& cell = cells[static_cast<std::size_t>(c)];
            const int wanted = static_cast<int>(cell.variance / remaining * extra + random_.uniform());
            remaining -= cell.variance;
            for (int k = 1; k <= wanted && extra > 0; ++k, --extra) {
                if (!sample_cell(half, c, at, radiance)) break;
                cell.mean *= static_cast<float>(k) / static_cast<float>(k + 1);
                cell.mean.add_scaled(radiance, 1.0f / static_cast<float>(k + 1));
            }
        }
    }
    for (const HemisphereCell& cell : cells) sum += cell.mean;
    scratch_->hemispheres[level] = std::move(cells);
    return traced > 0;
}

}  // namespace infra
