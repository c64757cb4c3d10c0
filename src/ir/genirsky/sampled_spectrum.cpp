#include "ir/genirsky/sampled_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "common/planck/planck.h"

namespace infra::ir {
namespace {

double value_at(const SampledSpectrum& spectrum, double place) {
    const std::vector<double>& x = spectrum.place;
    auto after = std::ranges::upper_bound(x, place) - x.begin();
    after = std::clamp<std::ptrdiff_t>(after, 1, static_cast<std::ptrdiff_t>(x.size()) - 1);
    const auto i = static_cast<std::size_t>(after);
    const double part = (place - x[i - 1]) / (x[i] - x[i - 1]);
    return spectrum.value[i - 1] + part * (spectrum.value[i] - spectrum.value[i - 1]);
}

/// Ends of a stretch of an axis.
struct Stretch {
    double from, to;
};

Stretch stretch(SpectralAxis to, SpectralAxis from, double a, double b) {
    const auto [low, high] = std::minmax({on_axis(to, from, a), on_axis(to, from, b)});
    return {low, high};
}

Stretch stretch(SpectralAxis axis, const Passband& passband) {
    return stretch(axis, SpectralAxis::wavelength, passband.shortest_um(), passband.longest_um());
}

void check_reach(const SampledSpectrum& spectrum, const Passband& passband) {
    constexpr double round_off = 1e-9;
    const Stretch band = stretch(SpectralAxis::wavenumber, passband);
    const Stretch file =
        stretch(SpectralAxis::wavenumber, spectrum.axis, spectrum.place.front(), spectrum.place.back());
    if (band.from >= file.from * (1 - round_off) && band.to <= file.to * (1 + round_off)) return;
    throw Error(
        Location{spectrum.file, spectrum.line},
        formatted("the band %.6g-%.6g um (%.6g-%.6g cm-1) reaches beyond the file's %.6g-%.6g cm-1",
                  passband.shortest_um(), passband.longest_um(), band.from, band.to, file.from, file.to));
}

/// Where the product of spectrum and weight has corners within the passband, ends included.
///   axis  of the result
std::vector<double> corners(const SampledSpectrum& spectrum, const Passband& passband, SpectralAxis axis) {
    const Stretch band = stretch(axis, passband);
    std::vector<double> nodes{band.from, band.to};
    const auto add = [&](SpectralAxis from, double place) {
        const double node = on_axis(axis, from, place);
        if (node > band.from && node < band.to) nodes.push_back(node);
    };
    for (const double place : spectrum.place) add(spectrum.axis, place);
    for (const SpectralResponse::Sample& sample : passband.samples())
        add(SpectralAxis::wavelength, sample.wavelength_um);
    std::ranges::sort(nodes);
    return nodes;
}

/// The same nodes and others between them, so that Planck's law bends little from one to the next.
std::vector<double> with_small_steps(const std::vector<double>& nodes) {
    constexpr double widest = 0.05;  // relative
    std::vector<double> result{nodes.front()};
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const double from = nodes[i - 1], step = nodes[i] - from;
        const double pieces = std::max(1., std::ceil(step / (widest * from)));
        for (double piece = 1; piece < pieces; ++piece) result.push_back(from + step * piece / pieces);
        result.push_back(nodes[i]);
    }
    return result;
}

/// Integral of `f` times the passband's weight along an axis, by three-point Gauss-Legendre between the
/// corners, in small steps. f(place on that axis)
template <class Function>
double weighted_integral(const SampledSpectrum& spectrum, const Passband& passband, SpectralAxis axis,
                         const Function& f) {
    check_reach(spectrum, passband);
    const double outer = std::sqrt(0.6);
    const std::array<std::array<double, 2>, 3> rule{{{-outer, 5. / 18}, {0, 8. / 18}, {outer, 5. / 18}}};
    const std::vector<double> nodes = with_small_steps(corners(spectrum, passband, axis));
    double sum = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const double middle = 0.5 * (nodes[i - 1] + nodes[i]), half = 0.5 * (nodes[i] - nodes[i - 1]);
        for (const auto& [offset, share] : rule) {
            const double place = middle + half * offset;
            const double weight = passband.weight(on_axis(SpectralAxis::wavelength, axis, place));
            sum += 2 * half * share * weight * f(place);
        }
    }
    return sum;
}

}  // namespace

double wavenumber_radiance(double temperature, double wavenumber) {
    const double um = um_cm / wavenumber;
    return spectral_radiance(temperature, um) * um / wavenumber;  // |d wavelength / d wavenumber|
}

double band_integral(const SampledSpectrum& spectrum, const Passband& passband) {
    const SpectralAxis axis = spectrum.density;
    return weighted_integral(spectrum, passband, axis, [&](double place) {
        return value_at(spectrum, on_axis(spectrum.axis, axis, place));
    });
}

double band_mean(const SampledSpectrum& spectrum, const Passband& passband, double temperature) {
    constexpr SpectralAxis axis = SpectralAxis::wavenumber;
    const auto black = [&](double wavenumber) { return wavenumber_radiance(temperature, wavenumber); };
    const double whole = weighted_integral(spectrum, passband, axis, black);
    const double seen = weighted_integral(spectrum, passband, axis, [&](double wavenumber) {
        return black(wavenumber) * value_at(spectrum, on_axis(spectrum.axis, axis, wavenumber));
    });
    if (!(whole > 0))
        throw Error(formatted("a black body of %g K has no radiance in %s", temperature,
                              passband.description().c_str()),
                    "-weight gives another temperature");
    return seen / whole;
}

}  // namespace infra::ir
