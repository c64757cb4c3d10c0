#include "nrlbrdf/distribution.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double largest_below_one = 0x1.fffffffffffffp-1;

/// Index of the first cumulated value above u; u becomes the place within its step, 0..1.
template <class T>
std::size_t choose(std::span<const T> cdf, double& u) {
    const auto found = std::upper_bound(cdf.begin(), cdf.end() - 1, u);
    const double below = found == cdf.begin() ? 0 : static_cast<double>(found[-1]);
    const double width = static_cast<double>(*found) - below;
    u = width > 0 ? std::clamp((u - below) / width, 0.0, largest_below_one) : 0;
    return static_cast<std::size_t>(found - cdf.begin());
}

/// One side of a hat on [start, start + step], rising or falling in theta, times cos sin.
class HatSide {
  public:
    HatSide(bool rising, double start, double step)
        : rising_(rising),
          start_(start),
          step_(step),
          sin_start_(std::sin(2 * start)),
          cos_start_(std::cos(2 * start)) {}

    double mass() const { return integral(start_ + step_).mass; }

    /// The theta below which lies the share u of `mass`, by Newton's method inside a shrinking bracket.
    double invert(double mass, double u) const {
        constexpr int most_iterations = 60;  // bisection alone would be exact by then
        constexpr double precision =
            1e-6;  // radians; Newton's last step leaves about its square over the step
        double lo = start_, hi = start_ + step_;
        double x = start_ + step_ * (rising_ ? std::sqrt(u) : 1 - std::sqrt(1 - u));
        for (int n = 0; n < most_iterations; ++n) {
            const auto [below, density] = integral(x);
            const double excess = below - mass * u;
            (excess > 0 ? hi : lo) = x;
            double next = density > 0 ? x - excess / density : (lo + hi) / 2;
            if (!(next > lo && next < hi)) next = (lo + hi) / 2;
            const double change = std::abs(next - x);
            x = next;
            if (change < precision) break;
        }
        return x;
    }

  private:
    struct Integral {
        double mass, density;
    };
    /// From start to x, with the integrand at x. By parts: (theta - start) sin(2 theta)/2.
    Integral integral(double x) const {
        const double s = std::sin(2 * x), c = std::cos(2 * x), along = (x - start_) / step_;
        const double rising = -along * c / 4 + (s - sin_start_) / (8 * step_);
        if (rising_) return {rising, along * s / 2};
        return {(cos_start_ - c) / 4 - rising, (1 - along) * s / 2};
    }

    bool rising_;
    double start_, step_, sin_start_, cos_start_;
};

/// Turns masses into cumulated shares that end in exactly 1; all of them zero stays unused.
template <class T>
void store_cdf(std::span<const double> masses, double total, std::span<T> cdf) {
    double sum = 0;
    for (std::size_t n = 0; n < masses.size(); ++n) {
        sum += masses[n];
        cdf[n] = static_cast<T>(total > 0 ? std::min(sum / total, 1.0) : 1.0);
    }
    // Nodes after the last with any mass are never chosen.
    for (std::size_t n = masses.size(); n-- > 0;) {
        cdf[n] = 1;
        if (masses[n] > 0) break;
    }
}

}  // namespace

TableDistribution::TableDistribution(std::shared_ptr<const BrdfTable> table) : table_(std::move(table)) {
    const int rows = table_->theta_i_count();
    const int columns = table_->phi_count();
    const int views = table_->theta_r_count();
    const double step = pi / 2 / (rows - 1);
    const auto row_count = static_cast<std::size_t>(rows);
    const auto column_count = static_cast<std::size_t>(columns);

    for (int i = 0; i < rows; ++i) {
        const double node = i * step;
        lower_half_.push_back(i == 0 ? 0 : HatSide(true, node - step, step).mass());
        upper_half_.push_back(i + 1 == rows ? 0 : HatSide(false, node, step).mass());
    }

    row_cdf_.resize(static_cast<std::size_t>(views) * row_count);
    phi_cdf_.resize(row_cdf_.size() * column_count);
    std::vector<double> row_masses(row_count), masses(column_count);
    for (int j = 0; j < views; ++j) {
        const auto first_row = static_cast<std::size_t>(j) * row_count;
        double all = 0;
        for (std::size_t i = 0; i < row_count; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < column_count; ++k)
                sum += masses[k] = table_->lobe_node(static_cast<int>(i), static_cast<int>(k), j);
            store_cdf(std::span<const double>(masses), sum,
                      std::span(phi_cdf_).subspan((first_row + i) * column_count, column_count));
            all += row_masses[i] = sum * (lower_half_[i] + upper_half_[i]);
        }
        store_cdf(std::span<const double>(row_masses), all,
                  std::span(row_cdf_).subspan(first_row, row_count));
    }
}

double TableDistribution::sample_theta(int i, double u) const {
    const double step = pi / 2 / (table_->theta_i_count() - 1);
    const double lower = lower_half_[static_cast<std::size_t>(i)];
    const double upper = upper_half_[static_cast<std::size_t>(i)];
    const double mass = u * (lower + upper);
    if (mass < lower) return HatSide(true, (i - 1) * step, step).invert(lower, mass / lower);
    return HatSide(false, i * step, step).invert(upper, std::min((mass - lower) / upper, 1.0));
}

Vec3 TableDistribution::sample(const Vec3& wo, double u1, double u2, double u3) const {
    // The neighbouring viewing angles, by what each contributes at this one.
    const GridPlace view = polar_place(polar_angle(wo), table_->theta_r_count());
    const double near = (1 - view.fraction) * table_->lobe_reflectance_node(view.cell);
    const double far = view.fraction * table_->lobe_reflectance_node(view.cell + 1);
    const int j = u1 * (near + far) < near ? view.cell : view.cell + 1;

    const auto rows = static_cast<std::size_t>(table_->theta_i_count());
    const auto columns = static_cast<std::size_t>(table_->phi_count());
    const std::size_t first_row = static_cast<std::size_t>(j) * rows;
    const std::size_t i = choose(std::span<const double>(row_cdf_).subspan(first_row, rows), u2);
    const std::size_t k =
        choose(std::span<const float>(phi_cdf_).subspan((first_row + i) * columns, columns), u3);

    const double theta = sample_theta(static_cast<int>(i), u2);
    const double hat = u3 < 0.5 ? std::sqrt(2 * u3) - 1 : 1 - std::sqrt(2 * (1 - u3));  // -1..1
    const double phi =
        table_->phi_origin() + (static_cast<double>(k) + hat) * 2 * pi / static_cast<double>(columns);

    const double azimuth = (wo.x == 0 && wo.y == 0 ? 0 : std::atan2(wo.y, wo.x)) - phi;
    const double sin_theta = std::sin(theta);
    return {sin_theta * std::cos(azimuth), sin_theta * std::sin(azimuth), std::cos(theta)};
}

}  // namespace infra
