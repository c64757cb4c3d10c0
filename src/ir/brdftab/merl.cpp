#include "ir/brdftab/merl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "common/error.h"
#include "nrlbrdf/half_vector.h"

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array<double, 3> channel_scales{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr std::size_t header_bytes = 12;
constexpr std::size_t cell_count =
    std::size_t{MerlTable::theta_h_count} * MerlTable::theta_d_count * MerlTable::phi_d_count;
constexpr float not_measured = -1;

static_assert(std::endian::native == std::endian::little, "MERL files are read as they lie in memory");

template <class T>
T read_at(std::string_view bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void check_layout(std::string_view bytes, const std::string& name) {
    const Location here{name};
    if (bytes.empty()) throw Error(here, "the file is empty");
    if (bytes.size() < header_bytes) throw Error(here, "too short for a MERL table");
    const std::int32_t counts[] = {read_at<std::int32_t>(bytes, 0), read_at<std::int32_t>(bytes, 4),
                                   read_at<std::int32_t>(bytes, 8)};
    if (counts[0] != MerlTable::theta_h_count || counts[1] != MerlTable::theta_d_count ||
        counts[2] != MerlTable::phi_d_count)
        throw Error(here,
                    "not a MERL table: counts " + std::to_string(counts[0]) + " " +
                        std::to_string(counts[1]) + " " + std::to_string(counts[2]),
                    "90 90 180 are expected");
    const std::size_t expected = header_bytes + 3 * cell_count * sizeof(double);
    if (bytes.size() != expected)
        throw Error(here, "found " + std::to_string(bytes.size()) + " bytes where a MERL table has " +
                              std::to_string(expected));
}

/// A place between cell centres: cells `low` and `high`, `fraction` of the way.
struct Place {
    int low, high;
    double fraction;
};

Place clamped_place(double cells, int count) {
    const double position = std::clamp(cells - 0.5, 0.0, count - 1.0);
    const int low = std::min(static_cast<int>(position), count - 2);
    return {low, low + 1, position - low};
}

Place periodic_place(double cells, int count) {
    const double position = cells - 0.5 < 0 ? cells - 0.5 + count : cells - 0.5;
    const int low = static_cast<int>(position) % count;
    return {low, (low + 1) % count, position - std::floor(position)};
}

}  // namespace

MerlTable::MerlTable(std::string_view bytes, MerlChannel channel, const std::string& name) {
    check_layout(bytes, name);
    values_.resize(cell_count);
    for (std::size_t n = 0; n < cell_count; ++n) {
        double sum = 0;
        int measured = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            if (channel != MerlChannel::mean && c != static_cast<std::size_t>(channel)) continue;
            const double raw = read_at<double>(bytes, header_bytes + (c * cell_count + n) * sizeof(double));
            if (!std::isfinite(raw))
                throw Error(Location{name}, "value " + std::to_string(n) + " of channel " +
                                                std::to_string(c) + " is not finite");
            if (raw < 0) continue;
            sum += raw * channel_scales[c];
            ++measured;
        }
        values_[n] = measured > 0 ? static_cast<float>(sum / measured) : not_measured;
    }
    fill(name);
    average_sides();
}

void MerlTable::fill(const std::string& name) {
    const std::vector<float> given = values_;
    for (int h = 0; h < theta_h_count; ++h)
        for (int d = 0; d < theta_d_count; ++d)
            for (int p = 0; p < phi_d_count; ++p) {
                float& value = values_[cell(h, d, p)];
                if (value >= 0) continue;
                ++filled_;
                for (int away = 1; value < 0 && away < theta_d_count; ++away) {
                    if (d - away >= 0) value = given[cell(h, d - away, p)];
                    if (value < 0 && d + away < theta_d_count) value = given[cell(h, d + away, p)];
                }
                for (int away = 1; value < 0 && away < theta_h_count; ++away) {
                    if (h - away >= 0) value = given[cell(h - away, d, p)];
                    if (value < 0 && h + away < theta_h_count) value = given[cell(h + away, d, p)];
                }
                if (value < 0)
                    throw Error(Location{name}, "no measured value near theta_h cell " + std::to_string(h) +
                                                    ", theta_d cell " + std::to_string(d));
            }
}

void MerlTable::average_sides() {
    for (int h = 0; h < theta_h_count; ++h)
        for (int d = 0; d < theta_d_count; ++d)
            for (int p = 0; p < phi_d_count / 2; ++p) {
                float& one = values_[cell(h, d, p)];
                float& other = values_[cell(h, d, phi_d_count - 1 - p)];
                one = other = (one + other) / 2;
            }
}

double MerlTable::operator()(double theta_i, double phi, double theta_r) const {
    const HalfVector half = half_vector(theta_i, phi, theta_r);
    const Place h = clamped_place(std::sqrt(half.theta_h / (pi / 2)) * theta_h_count, theta_h_count);
    const Place d = clamped_place(half.theta_d / (pi / 2) * theta_d_count, theta_d_count);
    const Place p = periodic_place(half.phi_d / pi * phi_d_count, phi_d_count);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto pick = [corner](int bit, const Place& at) {
            const bool upper = corner >> bit & 1;
            return std::pair(upper ? at.high : at.low, upper ? at.fraction : 1 - at.fraction);
        };
        const auto [hn, hw] = pick(0, h);
        const auto [dn, dw] = pick(1, d);
        const auto [pn, pw] = pick(2, p);
        sum += hw * dw * pw * static_cast<double>(values_[cell(hn, dn, pn)]);
    }
    return sum;
}

}  // namespace infra::ir
