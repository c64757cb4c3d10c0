#include "rt/ambient/irradiance_cache.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

namespace infra {
namespace {

constexpr std::size_t block_bytes = std::size_t(1) << 18, cache_line = 64;
constexpr int deepest = 40;
constexpr double tiny = 1e-6;
constexpr double rounding = 1 + 1e-5;  // of single precision, and some
/// Normals that differ by less are taken for the same whatever the accuracy, radians.
constexpr double least_angle = 10 * std::numbers::pi / 180;
/// A value that its gradients change by more is not used for a place.
constexpr double darkest = 0.05, brightest = 20;

using Float3 = float[3];

Vec3 vec(const Float3& v) { return Vec3(v[0], v[1], v[2]); }
void set(Float3& to, const Vec3& from) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

bool covers(const Cube& cube, const Vec3& point) {
    const Vec3 within = point - cube.origin;
    const auto inside = [&](double x) { return x >= 0 && x <= cube.size; };
    return inside(within.x) && inside(within.y) && inside(within.z);
}

int branch_of(const Cube& cube, const Vec3& point) {
    const Vec3 middle = cube.center();
    return (point.x > middle.x ? 1 : 0) | (point.y > middle.y ? 2 : 0) | (point.z > middle.z ? 4 : 0);
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

/// A value; its radiance follows it in memory. What most of the tests of a look-up need comes first.
struct IrradianceCache::Entry {
    Float3 point, normal;
    float reach2;  ///< square of the distance beyond which it is of no use
    std::int32_t level;
    float weight;
    std::uint32_t walls;
    Float3 axis;
    float radius[2];
    float gradient[2];
    float turn[2];

    float* radiance() { return reinterpret_cast<float*>(this + 1); }
    const float* radiance() const { return reinterpret_cast<const float*>(this + 1); }
};

/// Some of a cell's values, in a line of the processor's cache: their memory can be asked for all at once.
struct alignas(cache_line) IrradianceCache::Chunk {
    static constexpr std::uint32_t most = 6;

    Chunk* next = nullptr;
    std::atomic<std::uint32_t> count = 0;
    const Entry* entries[most];
};

/// Memory of values and cells.
struct alignas(cache_line) IrradianceCache::Block {
    std::byte bytes[block_bytes];
};

struct IrradianceCache::Node {
    std::atomic<Chunk*> values = nullptr;   ///< the newest first
    std::atomic<Node*> children = nullptr;  ///< 8 in a row
};

/// Where a value may be of use: the half of a ball above its surface.
struct IrradianceCache::Region {
    Vec3 point, normal;
    double reach, below;  ///< below: how far under the surface

    bool touches(const Cube& cube) const {
        double outside2 = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double from = point[axis] - cube.origin[axis];
            const double outside = std::max({-from, from - cube.size, 0.0});
            outside2 += outside * outside;
        }
        const double height = dot(cube.center() - point, normal);
        const double half_height =
            0.5 * cube.size * (std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z));
        return outside2 <= reach * reach && height + half_height >= -below;
    }
    bool within(const Cube& cube) const {
        for (int axis = 0; axis < 3; ++axis) {
            const double from = point[axis] - cube.origin[axis];
            if (from < reach || from > cube.size - reach) return false;
        }
        return true;
    }
};

/// A look-up under way.
struct IrradianceCache::Query {
    const IrradiancePlace& place;
    WallTest& walls;
    Spectrum& sum;
    double widest_angle;  ///< between normals
};

IrradianceCache::IrradianceCache(const Cube& cube, int channels, double accuracy, int resolution)
    : cube_(cube),
      channels_(channels),
      limits_(CacheLimits::of_scene(cube.size, accuracy, resolution)),
      root_(std::make_unique<Node>()),
      around_(std::make_unique<Node>()) {}

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
    const double widest =
        place.weight < heavy ? half_turn + (angle - half_turn) * std::pow(place.weight, 0.13) : angle;
    const Query query{place, walls, sum, widest};
    if (!covers(cube_, place.point)) return sum_entries(*around_, query);

    // Down to the smallest cell around the place, and up again: the values of small cells have little reach,
    // and are the better the nearer they are.
    const Node* path[deepest + 1];
    double sizes[deepest + 1];
    int depth = 0;
    Cube cube = cube_;
    path[0] = root_.get();
    sizes[0] = cube.size;
    while (const Node* const children = path[depth]->children.load(std::memory_order_acquire)) {
        const int branch = branch_of(cube, place.point);
        cube = cube.octant(branch);
        path[++depth] = children + branch;
        sizes[depth] = cube.size;
    }
    constexpr double enough = 0.05;
    double weight = sum_entries(*path[depth], query);
    while (depth-- > 0) {
        if (weight >= enough && 0.5 * sizes[depth] * limits_.accuracy > limits_.least_radius) break;
        weight += sum_entries(*path[depth], query);
    }
    return weight;
}

double IrradianceCache::sum_entries(const Node& node, const Query& query) const {
    double sum = 0;
    for (const Chunk* chunk = node.values.load(std::memory_order_acquire); chunk; chunk = chunk->next) {
        const std::uint32_t count = chunk->count.load(std::memory_order_acquire);
        for (std::uint32_t i = 0; i < count; ++i) sum += add_entry(*chunk->entries[i], query);
    }
    return sum;
}

// Returns the weight that the value has for the place.
inline double IrradianceCache::add_entry(const Entry& entry, const Query& query) const {
    const IrradiancePlace& place = query.place;
    // Values of later bounces are too coarse, as are those sampled for lighter rays
    if (entry.level > place.level || static_cast<double>(entry.weight) < 0.9 * place.weight) return 0;
    const Vec3 step = place.point - vec(entry.point);
    if (dot(step, step) >= static_cast<double>(entry.reach2)) return 0;
    const Vec3 normal = vec(entry.normal);
    const double cosine = dot(normal, place.normal);
    const double angle2 = 2 - 2 * cosine, widest = query.widest_angle;
    if (cosine <= 0 || angle2 >= widest * widest) return 0;

    const double accuracy = limits_.accuracy;
    const double height = dot(step, normal);
    if (height < -limits_.least_radius * accuracy) return 0;
    const double radius[2] = {entry.radius[0], entry.radius[1]};
    const Vec3 u = vec(entry.axis);
    const Vec3 v = cross(normal, u);
    const double along_u = dot(step, u), along_v = dot(step, v);
    const double h = height / radius[0], x = along_u / radius[0], y = along_v / radius[1];
    const double distance2 = h * h + x * x + y * y;
    if (distance2 >= accuracy * accuracy) return 0;

    if (entry.walls != 0) {
        const double toward = std::atan2(along_v, along_u) * (wall_sectors / (2 * std::numbers::pi));
        const int sector = static_cast<int>(std::floor(toward)) & (wall_sectors - 1);
        if (entry.walls >> sector & 1 && hidden(vec(entry.point), normal, place, query.walls)) return 0;
    }

    const Vec3 turning = cross(normal, place.shading_normal);
    const double factor = std::min(
        change(step, turning, u, v, entry.gradient[0], entry.gradient[1], entry.turn[0], entry.turn[1]),
        brightest);
    if (factor <= darkest) return 0;
    const double weight =
        (1 - std::sqrt(std::max(angle2, 0.0)) / widest) * (1 - std::sqrt(distance2) / accuracy);
    const float scale = static_cast<float>(weight * factor);
    const float* const radiance = entry.radiance();
    for (int c = 0; c < channels_; ++c) query.sum.set(c, query.sum[c] + scale * radiance[c]);
    return weight;
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
    Entry* const entry = new (allocate(value_bytes(channels_), alignof(Entry))) Entry;
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

    const double reach = value.radius[1] * limits_.accuracy;
    entry->reach2 = static_cast<float>(reach * reach * rounding);
    const Region region{value.point, value.normal, reach * rounding,
                        limits_.least_radius * limits_.accuracy * rounding + tiny * reach};
    list(*entry, region, *root_, cube_, 0);
    if (!region.within(cube_)) append(*entry, *around_);

    size_.fetch_add(1, std::memory_order_relaxed);
    const double brightness = static_cast<double>(value.radiance.brightness());
    if (brightness > tiny) {
        log_sum_ += std::log(brightness);
        const std::size_t count = lit_.load(std::memory_order_relaxed) + 1;
        mean_log_.store(log_sum_ / static_cast<double>(count), std::memory_order_relaxed);
        lit_.store(count, std::memory_order_relaxed);
    }
}

// Lists a value in all cells that it may be of use in, of those no narrower than it reaches.
void IrradianceCache::list(const Entry& entry, const Region& region, Node& node, const Cube& cube,
                           int depth) {
    if (!region.touches(cube)) return;
    if (depth == deepest || 0.5 * cube.size <= region.reach) return append(entry, node);
    Node* children = node.children.load(std::memory_order_relaxed);
    if (!children) {
        children = new (allocate(8 * sizeof(Node), alignof(Chunk))) Node[8];
        node.children.store(children, std::memory_order_release);
    }
    for (int branch = 0; branch < 8; ++branch)
        list(entry, region, children[branch], cube.octant(branch), depth + 1);
}

void IrradianceCache::append(const Entry& entry, Node& node) {
    Chunk* chunk = node.values.load(std::memory_order_relaxed);
    const std::uint32_t count = chunk ? chunk->count.load(std::memory_order_relaxed) : Chunk::most;
    if (count < Chunk::most) {
        chunk->entries[count] = &entry;
        chunk->count.store(count + 1, std::memory_order_release);
        return;
    }
    Chunk* const fresh = new (allocate(sizeof(Chunk), alignof(Chunk))) Chunk;
    fresh->next = chunk;
    fresh->entries[0] = &entry;
    fresh->count.store(1, std::memory_order_relaxed);
    node.values.store(fresh, std::memory_order_release);
}

std::byte* IrradianceCache::allocate(std::size_t bytes, std::size_t alignment) {
    block_used_ = (block_used_ + alignment - 1) / alignment * alignment;
    if (blocks_.empty() || block_used_ + bytes > block_bytes) {
        blocks_.push_back(std::make_unique_for_overwrite<Block>());
        block_used_ = 0;
    }
    std::byte* const start = blocks_.back()->bytes + block_used_;
    block_used_ += bytes;
    return start;
}

}  // namespace infra
