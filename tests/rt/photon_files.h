// Photon map files, for tests of those who read them: photons balanced into a kd-tree and encoded as
// rt/photons/photon_file.h says.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "common/pictures/rgbe.h"
#include "common/random.h"
#include "common/vec.h"
#include "rt/photons/photon_map.h"
#include "scene/byte_writer.h"

namespace infra::test {

inline Photon photon(const Vec3& position, const Vec3& direction, const Rgbe& flux, bool caustic = false) {
    Photon made{};
    for (std::size_t i = 0; i < 3; ++i) {
        made.position[i] = static_cast<float>(position[static_cast<int>(i)]);
        made.direction[i] = static_cast<std::int8_t>(127 * direction[static_cast<int>(i)]);
    }
    made.flux = flux;
    made.flags = caustic ? 4 : 0;
    return made;
}

/// Flux of (mantissa + 1/2) 2^-20 in all channels: what photons of tests carry.
inline Rgbe grey_flux(std::uint8_t mantissa) { return {mantissa, mantissa, mantissa, 116}; }
inline double flux_of(const Rgbe& flux) { return static_cast<double>(from_rgbe(flux)[0]); }

class PhotonTree {
  public:
    explicit PhotonTree(std::vector<Photon> photons) : heap_(photons.size()) {
        build(photons.data(), photons.size(), 1);
    }
    const std::vector<Photon>& heap() const { return heap_; }

  private:
    /// Nodes left of the root in a heap of n nodes.
    static std::size_t left_size(std::size_t n) {
        const std::size_t last_row = std::bit_floor(n);  // room in the last level
        const std::size_t above = last_row - 1;          // nodes above it
        const std::size_t half = last_row / 2;
        return (above - 1) / 2 + std::min(n - above, half);
    }
    void build(Photon* first, std::size_t n, std::size_t node) {
        if (n == 0) return;
        std::size_t axis = 0;
        float widest = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [least, greatest] = std::minmax_element(
                first, first + n,
                [i](const Photon& a, const Photon& b) { return a.position[i] < b.position[i]; });
            const float width = greatest->position[i] - least->position[i];
            if (width > widest) widest = width, axis = i;
        }
        const std::size_t left = n == 1 ? 0 : left_size(n);
        std::nth_element(first, first + left, first + n, [axis](const Photon& a, const Photon& b) {
            return a.position[axis] < b.position[axis];
        });
        Photon& root = heap_[node - 1] = first[left];
        root.flags = static_cast<std::uint8_t>(root.flags | axis);
        build(first, left, 2 * node);
        build(first + left + 1, n - left - 1, 2 * node + 1);
    }

    std::vector<Photon> heap_;
};

/// Mean square distance from the mean place.
inline double spread2(const std::vector<Photon>& photons) {
    Vec3 mean(0);
    const auto place = [](const Photon& p) { return Vec3(p.position[0], p.position[1], p.position[2]); };
    for (const Photon& p : photons) mean += place(p) / static_cast<double>(photons.size());
    double sum = 0;
    for (const Photon& p : photons) sum += dot(place(p) - mean, place(p) - mean);
    return sum / static_cast<double>(photons.size());
}

inline PhotonMap map_of(PhotonKind kind, const std::vector<Photon>& photons) {
    PhotonMap map(kind, photons.size(), spread2(photons));
    const PhotonTree tree(photons);
    for (std::size_t i = 0; i < photons.size(); ++i) map.place(i, tree.heap()[i]);
    return map;
}

/// word: "Global", "PreComp", "Caustic", "Volume", "Direct" or "Contrib".
inline void write_photon_map(const std::string& path, const std::string& word,
                             const std::vector<Photon>& photons, int primary_rays = 0) {
    std::ofstream file(path, std::ios::binary);
    ByteWriter out(file);
    out.text("#?RADIANCE\nmkpmap\nFORMAT=Radiance_" + word + "_kdT_Photon_Map\nVERSION=3.1k\n\n");
    out.string("3.1k");
    out.integer(static_cast<std::int64_t>(photons.size()), 8);
    for (int i = 0; i < 12; ++i) out.real(0.25 * i);
    out.real(spread2(photons));
    out.integer(primary_rays, 4);
    for (int i = 0; i < primary_rays; ++i) out.integer(0, 2);
    const PhotonTree tree(photons);
    for (const Photon& p : tree.heap()) {
        for (const float x : p.position) out.real(static_cast<double>(x));
        for (const std::int8_t d : p.direction) out.byte(d);
        for (const std::uint8_t f : p.flux) out.byte(f);
        out.integer(7, 4);
        out.byte(p.flags);
    }
    out.finish();
}

/// Photons spread at random over a parallelogram.
inline std::vector<Photon> on_plane(const Vec3& corner, const Vec3& u, const Vec3& v, const Vec3& normal,
                                    std::size_t count, const Rgbe& flux, std::uint64_t seed,
                                    bool caustic = false) {
    RandomStream random(seed, 0);
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        const double s = random.uniform(), t = random.uniform();
        photons.push_back(photon(corner + u * s + v * t, normal, flux, caustic));
    }
    return photons;
}

}  // namespace infra::test
