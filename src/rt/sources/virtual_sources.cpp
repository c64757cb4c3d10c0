#include "rt/sources/virtual_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt/sources/pretest.h"

namespace infra {
namespace {

/// Half the angle that a ball is seen under from a point outside; pi from inside.
double half_angle(double radius, double distance) {
    return radius < distance ? std::asin(radius / distance) : std::numbers::pi;
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), -1.0, 1.0));
}

RelayDisk image_of(const RelayDisk& disk, const Projection& projection) {
    const double stretch = projection.is_rigid ? 1.0 : 1.0 + length(projection.shift);
    return {projection.point(disk.center), disk.radius * stretch};
}

/// Whether a straight line from a source can pass through both disks.
bool sees_through(const LightSource& source, const RelayDisk& first, const RelayDisk& second) {
    const double radii = first.radius + second.radius;
    if (source.distant()) {
        const double spread = source.radius;  // half the source's angle
        if (spread > 1.5) return true;
        const Vec3 offset = second.center - first.center;
        const double along = std::fabs(dot(offset, source.center));
        const double across = std::sqrt(std::max(0.0, dot(offset, offset) - along * along));
        return across <= radii + (along + radii) * std::tan(spread);
    }
    const Vec3 a = first.center - source.center, b = second.center - source.center;
    const double spread = half_angle(first.radius + source.radius, length(a)) +
                          half_angle(second.radius + source.radius, length(b));
    return spread >= std::numbers::pi || angle_between(a, b) <= spread;
}

/// Whether a local source shines towards a disk at all.
bool shines_on(const LightSource& source, const RelayDisk& disk) {
    const Vec3 offset = disk.center - source.center;
    const double distance = length(offset);
    if (source.is_glow && distance - disk.radius - source.radius > source.reach) return false;
    if (source.extent == LightSource::Extent::flat && dot(offset, source.normal) + disk.radius <= same_place)
        return false;
    if (!source.is_spot) return true;
    const double beam = std::acos(std::max(-1.0, 1.0 - source.beam.solid_angle / (2 * std::numbers::pi)));
    const double spread = beam + half_angle(disk.radius + source.radius, distance);
    return spread >= std::numbers::pi || angle_between(offset, source.beam.axis) <= spread;
}

/// Whether any of a surface lies on that side of a relay where its image shines to.
bool lies_before(const RelaySurface& surface, const RelaySurface& relay, const LightSource& image) {
    const double height = dot(relay.normal, image.center) - (image.distant() ? 0.0 : relay.offset);
    const double away = (dot(relay.normal, surface.disk.center) - relay.offset) * (height > 0 ? -1 : 1);
    const double cosine = dot(relay.normal, surface.normal);
    return away > -surface.disk.radius * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

/// A source on the way through mirrors: what its light has passed so far, as seen from it.
struct Path {
    int source;
    const RelaySurface* last = nullptr;  ///< nullptr: a real source
    std::vector<RelayDisk> windows;
};

class ImageMaker {
  public:
    ImageMaker(const CompiledScene& scene, const RenderSettings& settings,
               const std::vector<RelaySurface>& relays, std::vector<LightSource>& sources)
        : scene_(scene), relays_(relays), sources_(sources), tracer_(scene, settings), pretest_(tracer_) {}

    void add_images(const Path& path, int relays_left) {
        if (relays_left <= 0) return;
        for (const RelaySurface& surface : relays_) {
            if (!reaches(path, surface)) continue;
            for (int n = 0; n < surface.relay->image_count(); ++n) add_image(path, surface, n, relays_left);
        }
    }

  private:
    bool reaches(const Path& path, const RelaySurface& surface) const {
        const LightSource& source = sources_[static_cast<std::size_t>(path.source)];
        if (surface.surface == source.surface) return false;
        if (!source.distant() && !shines_on(source, surface.disk)) return false;
        if (path.last && !lies_before(surface, *path.last, source)) return false;
        return std::all_of(path.windows.begin(), path.windows.end(), [&](const RelayDisk& window) {
            return sees_through(source, window, surface.disk);
        });
    }

    void add_image(const Path& path, const RelaySurface& surface, int n, int relays_left) {
        const LightSource parent = sources_[static_cast<std::size_t>(path.source)];
        Projection projection;
        if (!surface.relay->project(tracer_, surface, parent, n, projection)) return;
        if (!pretest_.sees(surface, path.source)) return;

        LightSource image = make_image(parent, surface, projection);
        image.parent = path.source;
        image.image = n;
        Path next{static_cast<int>(sources_.size()), &surface, {surface.disk}};
        for (const RelayDisk& window : path.windows) next.windows.push_back(image_of(window, projection));
        sources_.push_back(image);
        add_images(next, relays_left - 1);
    }

    LightSource make_image(const LightSource& parent, const RelaySurface& surface,
                           const Projection& projection) const {
        LightSource image = parent;
        image.surface = surface.surface;
        image.modifier = scene_.finish(surface.surface).modifier;
        image.even_radiance = nullptr;
        image.disk = surface.disk;
        image.passes_unseen = image.is_weak = false;
        image.center =
            parent.distant() ? normalize(projection.vector(parent.center)) : projection.point(parent.center);
        if (length(parent.normal) > 0) image.normal = normalize(projection.vector(parent.normal));
        for (Vec3& axis : image.half_axis) axis = projection.vector(axis);
        if (image.is_spot) {
            image.beam.axis = normalize(projection.vector(parent.beam.axis));
            if (!projection.is_rigid) image.beam.solid_angle = 4 * std::numbers::pi;  // no longer a cone
        }
        return image;
    }

    const CompiledScene& scene_;
    const std::vector<RelaySurface>& relays_;
    std::vector<LightSource>& sources_;
    Tracer tracer_;
    Pretest pretest_;
};

}  // namespace

void add_virtual_sources(const CompiledScene& scene, const RenderSettings& settings,
                         const std::vector<RelaySurface>& relays, std::vector<LightSource>& sources) {
    if (relays.empty() || settings.direct_relays <= 0) return;
    ImageMaker maker(scene, settings, relays, sources);
    const int real = static_cast<int>(sources.size());
    for (int i = 0; i < real; ++i)
        if (!sources[static_cast<std::size_t>(i)].skip)
            maker.add_images({i, nullptr, {}}, settings.direct_relays);
}

}  // namespace infra
