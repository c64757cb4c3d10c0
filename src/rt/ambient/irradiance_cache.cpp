#include "rt/ambient/irradiance_cache.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

namespace infra {
namespace {

constexpr std::size_t block_bytes = std::size_t(1) << 18;
constexpr int deepest = 40;
constexpr double tiny = 1e-6;
/// Normals that differ by less are taken for the same whatever the accuracy, radians.
constexpr double least_angle = 10 * std::numbers::pi / 180;
/// A value that its gradients change by more is not used for a place.
constexpr double darkest = 0.05, brightest = 20;

using Float3 = float[3];

Vec3 vec(const Float3& v) { return Vec3(v[0], v[1], v[2]); }
void set(Float3& to, const Vec3& from) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

/// Factor of a value for a place at `step` from it: 1 and the changes along the gradients.
double change(const Vec3& step, const Vec3& turning, const Vec3& u, const Vec3& v, double gradient_u,
              double gradient_v, double turn_u, double turn_v) {
    return 1 + gradient_u * dot(step, u) + gradient_v * dot(step, v) + turn_u * dot(turning, u) +
           turn_v * dot(turning, v);
}

/// Whether something hides from a place what is seen from a value's point. The ray goes to the value's
/// normal, at a height that clears what lies low between them.
bool hidden(const Vec3& point, const Vec3& normal, const IrradiancePlace& place, WallTest& walls) {
    constexpr double height2 = 0.1169778;  // of the ray over the place's plane: (sin 20 degrees)^2
    const Vec3 step = point - place.point;
    const double normals = dot(normal, place.normal), rise = dot(step, place.normal);
    const double a = normals * normals - height2;
    const double half_b = normals * rise - dot(step, normal) * height2;
    const double c = rise * rise - dot(step, step) * height2;
    const double root2 = half_b * half_b - a * c;
    if (!(root2 > 0) || std::fabs(a) < tiny) return true;
    const double lift = std::max((-half_b + std::sqrt(root2)) / a, (-half_b - std::sqrt(root2)) / a);
    return lift > tiny && walls.hides(point + normal * lift);
}

}  // namespace

/// A value in the tree; its radiance follows it in memory.
struct IrradianceCache::Entry {
    std::atomic<Entry*> next;
    Float3 point, normal, axis;
    float weight;
    float radius[2];
    float gradient[2];
    float turn[2];
    std::uint32_t walls;
    std::int32_t level;

    float* radiance() { return reinterpret_cast<float*>(this + 1); }
    const float* radiance() const { return reinterpret_cast<const float*>(this + 1); }
    bool comes_before(const Entry& other) const {  // in a node's list
        return level < other.level || (level == other.level && weight > other.weight);
    }
};

struct IrradianceCache::Node {
    std::atomic<Entry*> entries = nullptr;
    std::atomic<Node*> children = nullptr;  ///< 8 in a row
};

/// A look-up under way.
struct IrradianceCache::Query {
    const IrradiancePlace& place;
    WallTest& walls;
    Spectrum& sum;
    double widest_angle;
    double widest_angle_light;  ///< among values that the place's level may use, for a ray of little weight
};

IrradianceCache::IrradianceCache(const Cube& cube, int channels, double accuracy, int resolution)
    : cube_(cube),
      channels_(channels),
      limits_(CacheLimits::of_scene(cube.size, accuracy, resolution)),
      root_(std::make_unique<Node>()) {}

IrradianceCache::~IrradianceCache() = default;

std::size_t IrradianceCache::value_bytes(int channels) {
    const std::size_t size = sizeof(Entry) + sizeof(float) * static_cast<std::size_t>(channels);
    return (size + alignof(Entry) - 1) / alignof(Entry) * alignof(Entry);
}

// Reading
// -----------------------------------------------------------------------------------------------------

double IrradianceCache::interpolate(const IrradiancePlace& place, WallTest& walls, Spectrum& sum) const {
    constexpr double half_turn = std::numbers::pi / 2, heavy = 0.6;
    const double angle = least_angle + limits_.accuracy;
    const double light =
        place.weight < heavy ? half_turn + (angle - half_turn) * std::pow(place.weight, 0.13) : angle;
    Query query{place, walls, sum, angle, light};
    return sum_tree(*root_, cube_, query);
}

// A value lies in a cell about as wide as it reaches, so that it can only matter to this cell and its
// neighbours.
double IrradianceCache::sum_tree(const Node& node, const Cube& cube, Query& query) const {
    constexpr double enough = 0.05;
    double weight = 0;
    if (const Node* const children = node.children.load(std::memory_order_acquire)) {
        const double half = 0.5 * cube.size;
        for (int branch = 0; branch < 8; ++branch) {
            const Cube octant = cube.octant(branch);
            const Vec3 from = query.place.point - octant.origin;
            const auto near = [&](double x) { return x >= -half && x <= 2 * half; };
            if (near(from.x) && near(from.y) && near(from.z))
                weight += sum_tree(children[branch], octant, query);
        }
        if (weight >= enough && half * limits_.accuracy > limits_.least_radius) return weight;
    }
    return weight + sum_entries(node, query);
}

double IrradianceCache::sum_entries(const Node& node, Query& query) const {
    const IrradiancePlace& place = query.place;
    const double accuracy = limits_.accuracy;
    const Entry* entry = node.entries.load(std::memory_order_acquire);
    const double widest =
        entry && entry->level <= place.level ? query.widest_angle_light : query.widest_angle;
    double sum = 0;
    for (; entry; entry = entry->next.load(std::memory_order_acquire)) {
        // Values of later bounces are too coarse, as are those sampled for lighter rays
        if (entry->level > place.level) break;
        if (static_cast<double>(entry->weight) < 0.9 * place.weight) {
            if (entry->level == place.level) break;
            continue;
        }
        const Vec3 normal = vec(entry->normal);
        const double cosine = dot(normal, place.normal);
        if (cosine <= 0) continue;
        const double angle2 = 2 - 2 * cosine;
        if (angle2 >= widest * widest) continue;

        const Vec3 step = place.point - vec(entry->point);
        const double height = dot(step, normal);
        if (height < -limits_.least_radius * accuracy) continue;
        const double radius[2] = {entry->radius[0], entry->radius[1]};
        const Vec3 u = vec(entry->axis);
        const Vec3 v = cross(normal, u);
        const double along_u = dot(step, u), along_v = dot(step, v);
        const double h = height / radius[0], x = along_u / radius[0], y = along_v / radius[1];
        const double distance2 = h * h + x * x + y * y;
        if (distance2 >= accuracy * accuracy) continue;

        if (entry->walls != 0) {
            const double toward = std::atan2(along_v, along_u) * (wall_sectors / (2 * std::numbers::pi));
            const int sector = static_cast<int>(std::floor(toward)) & (wall_sectors - 1);
            if (entry->walls >> sector & 1 && hidden(vec(entry->point), normal, place, query.walls)) continue;
        }

        const Vec3 turning = cross(normal, place.shading_normal);
        const double factor = std::min(change(step, turning, u, v, entry->gradient[0], entry->gradient[1],
                                              entry->turn[0], entry->turn[1]),
                                       brightest);
        if (factor <= darkest) continue;
        const double weight =
            (1 - std::sqrt(std::fmax(angle2, 0.0)) / widest) * (1 - std::sqrt(distance2) / accuracy);
        const float scale = static_cast<float>(weight * factor);
        const float* const radiance = entry->radiance();
        for (int c = 0; c < channels_; ++c) query.sum.set(c, query.sum[c] + scale * radiance[c]);
        sum += weight;
    }
    return sum;
}

bool extrapolate(const IrradianceValue& value, const IrradiancePlace& place, Spectrum& radiance) {
    const double factor =
        std::clamp(change(place.point - value.point, cross(value.normal, place.shading_normal), value.axis,
                          cross(value.normal, value.axis), value.gradient[0], value.gradient[1],
                          value.turn[0], value.turn[1]),
                   darkest, brightest);
    radiance = value.radiance * static_cast<float>(factor);
    return factor > darkest;
}

// Writing
// -----------------------------------------------------------------------------------------------------

void IrradianceCache::share_with(std::unique_ptr<AmbientFile> file) {
    const std::lock_guard lock(writer_);
    file_ = std::move(file);
    file_->read_new([this](const IrradianceValue& value) { store(value); });
}

void IrradianceCache::flush() {
    const std::lock_guard lock(writer_);
    if (file_) file_->exchange([this](const IrradianceValue& value) { store(value); });
}

void IrradianceCache::add(const IrradianceValue& value) {
    const std::lock_guard lock(writer_);
    store(value);
    if (file_ && file_->append(value))
        file_->exchange([this](const IrradianceValue& other) { store(other); });
}

void IrradianceCache::store(const IrradianceValue& value) {
    Entry* const entry = new (allocate(value_bytes(channels_))) Entry;
    set(entry->point, value.point);
    set(entry->normal, value.normal);
    set(entry->axis, value.axis);
    entry->weight = static_cast<float>(value.weight);
    for (int i = 0; i < 2; ++i) {
        entry->radius[i] = static_cast<float>(value.radius[i]);
        entry->gradient[i] = static_cast<float>(value.gradient[i]);
        entry->turn[i] = static_cast<float>(value.turn[i]);
    }
    entry->walls = value.walls;
    entry->level = value.level;
    for (int c = 0; c < channels_; ++c) entry->radiance()[c] = value.radiance[c];

    std::atomic<Entry*>* link = &node_for(value.point, value.radius[1] * limits_.accuracy).entries;
    Entry* next = link->load(std::memory_order_relaxed);
    for (; next && next->comes_before(*entry); next = link->load(std::memory_order_relaxed))
        link = &next->next;
    entry->next.store(next, std::memory_order_relaxed);
    link->store(entry, std::memory_order_release);

    size_.fetch_add(1, std::memory_order_relaxed);
    const double brightness = static_cast<double>(value.radiance.brightness());
    if (brightness > tiny) {
        log_sum_ += std::log(brightness);
        const std::size_t count = lit_.load(std::memory_order_relaxed) + 1;
        mean_log_.store(log_sum_ / static_cast<double>(count), std::memory_order_relaxed);
        lit_.store(count, std::memory_order_relaxed);
    }
}

// The smallest cell around a point that is at least as wide as a value reaches to both sides; the whole scene
// for places outside it.
IrradianceCache::Node& IrradianceCache::node_for(const Vec3& point, double reach) {
    const Vec3 within = point - cube_.origin;
    const auto inside = [&](double x) { return x >= 0 && x <= cube_.size; };
    Node* node = root_.get();
    if (!inside(within.x) || !inside(within.y) || !inside(within.z)) return *node;
    Cube cube = cube_;
    for (int depth = 0; depth < deepest && 0.5 * cube.size > reach; ++depth) {
        Node* children = node->children.load(std::memory_order_relaxed);
        if (!children) {
            children = new (allocate(8 * sizeof(Node))) Node[8];
            node->children.store(children, std::memory_order_release);
        }
        const Vec3 middle = cube.center();
        const int branch =
            (point.x > middle.x ? 1 : 0) | (point.y > middle.y ? 2 : 0) | (point.z > middle.z ? 4 : 0);
        node = children + branch;
        cube = cube.octant(branch);
    }
    return *node;
}

std::byte* IrradianceCache::allocate(std::size_t bytes) {
    if (blocks_.empty() || block_used_ + bytes > block_bytes) {
        blocks_.push_back(std::make_unique<std::byte[]>(block_bytes));
        block_used_ = 0;
    }
    std::byte* const start = blocks_.back().get() + block_used_;
    block_used_ += bytes;
    return start;
}

}  // namespace infra
