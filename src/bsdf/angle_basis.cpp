#include "bsdf/angle_basis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace infra {
namespace {

constexpr double degree = std::numbers::pi / 180;

double squared_cosine(double angle_deg) {
    const double c = std::cos(angle_deg * degree);
    return c * c;
}

constexpr AngleRing full[] = {{5, 1},   {15, 8},  {25, 16}, {35, 20}, {45, 24},
                              {55, 24}, {65, 24}, {75, 16}, {90, 12}};
constexpr AngleRing half[] = {{6.5, 1}, {19.5, 8}, {32.5, 12}, {45.5, 16}, {58.5, 20}, {71.5, 12}, {90, 8}};
constexpr AngleRing quarter[] = {{9, 1}, {27, 8}, {45, 12}, {63, 12}, {90, 8}};

}  // namespace

AngleBasis::AngleBasis(std::string name, std::span<const AngleRing> rings) : name_(std::move(name)) {
    int patch = 0;
    double inner = 1;
    for (const AngleRing& ring : rings) {
        const double outer = squared_cosine(ring.upper_deg);
        rings_.push_back({ring.upper_deg, ring.sectors, patch, inner, outer,
                          std::numbers::pi * (inner - outer) / ring.sectors});
        patch_ring_.insert(patch_ring_.end(), static_cast<std::size_t>(ring.sectors), rings_.size() - 1);
        patch += ring.sectors;
        inner = outer;
    }
}

int AngleBasis::patch_of(const Vec3& d) const {
    if (d.z < 0) return -1;
    const double polar_deg = std::acos(std::min(d.z, 1.0)) / degree;
    const auto ring =
        std::ranges::find_if(rings_, [&](const Ring& candidate) { return polar_deg < candidate.upper_deg; });
    if (ring == rings_.end()) return -1;
    double turn = std::atan2(d.y, d.x) * (0.5 * std::numbers::inv_pi);
    if (turn < 0) turn += 1;
    const int sector = static_cast<int>(turn * ring->sectors + 0.5);
    return ring->first_patch + (sector < ring->sectors ? sector : 0);
}

Vec3 AngleBasis::direction(int patch, double u, double v) const {
    const Ring& ring = rings_[patch_ring_[static_cast<std::size_t>(patch)]];
    const double cosine2 = ring.inner_cos2 + u * (ring.outer_cos2 - ring.inner_cos2);
    const double sine = std::sqrt(1 - cosine2);
    const double azimuth = 2 * std::numbers::pi * (patch - ring.first_patch + v - 0.5) / ring.sectors;
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(cosine2)};
}

const AngleBasis* standard_angle_basis(std::string_view name) {
    static const AngleBasis bases[] = {
        {"LBNL/Klems Full", full}, {"LBNL/Klems Half", half}, {"LBNL/Klems Quarter", quarter}};
    for (const AngleBasis& basis : bases)
        if (same_name(basis.name(), name)) return &basis;
    return nullptr;
}

bool same_name(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace infra
