#include "ir/genirsky/sampled_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "common/planck/planck.h"

namespace infra::ir {
namespace {

constexpr double um_cm = 1e4;  // wavelength in um times wavenumber in cm^-1

double value_at(const SampledSpectrum& spectrum, double wavenumber) {
    const std::vector<double>& x = spectrum.wavenumber;
    auto after = std::ranges::upper_bound(x, wavenumber) - x.begin();
    after = std::clamp<std::ptrdiff_t>(after, 1, static_cast<std::ptrdiff_t>(x.size()) - 1);
    const auto i = static_cast<std::size_t>(after);
    const double part = (wavenumber - x[i - 1]) / (x[i] - x[i - 1]);
    return spectrum.value[i - 1] + part * (spectrum.value[i] - spectrum.value[i - 1]);
}

void check_reach(const SampledSpectrum& spectrum, double from, double to) {
    constexpr double round_off = 1e-9;
    if (from >= spectrum.wavenumber.front() * (1 - round_off) &&
        to <= spectrum.wavenumber.back() * (1 + round_off))
        return;
    throw Error(Location{spectrum.file, 0},
                formatted("the band %.6g-%.6g um (%.6g-%.6g cm-1) reaches beyond the file's %.6g-%.6g cm-1",
                          um_cm / to, um_cm / from, from, to, spectrum.wavenumber.front(),
                          spectrum.wavenumber.back()));
}

/// Where the product of spectrum and weight has corners between `from` and `to`, ends included.
std::vector<double> corners(const SampledSpectrum& spectrum, const Passband& passband, double from,
                            double to) {
    std::vector<double> nodes{from, to};
    for (const double wavenumber : spectrum.wavenumber)
        if (wavenumber > from && wavenumber < to) nodes.push_back(wavenumber);
    for (const SpectralResponse::Sample& sample : passband.samples()) {
        const double wavenumber = um_cm / sample.wavelength_um;
        if (wavenumber > from && wavenumber < to) nodes.push_back(wavenumber);
    }
    std::ranges::sort(nodes);
    return nodes;
}

/// Integral of `f` times the passband's weight, by three-point Gauss-Legendre between the corners.
template <class Function>
double weighted_integral(const SampledSpectrum& spectrum, const Passband& passband, const Function& f) {
    const double from = um_cm / passband.longest_um(), to = um_cm / passband.shortest_um();
    check_reach(spectrum, from, to);
    const double outer = std::sqrt(0.6);
    const std::array<std::array<double, 2>, 3> rule{{{-outer, 5. / 18}, {0, 8. / 18}, {outer, 5. / 18}}};
    const std::vector<double> nodes = corners(spectrum, passband, from, to);
    double sum = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const double middle = 0.5 * (nodes[i - 1] + nodes[i]), half = 0.5 * (nodes[i] - nodes[i - 1]);
        for (const auto& [place, share] : rule) {
            const double wavenumber = middle + half * place;
            sum += 2 * half * share * passband.weight(um_cm / wavenumber) * f(wavenumber);
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
    return weighted_integral(spectrum, passband,
                             [&](double wavenumber) { return value_at(spectrum, wavenumber); });
}

double band_mean(const SampledSpectrum& spectrum, const Passband& passband, double temperature) {
    const double whole = weighted_integral(
        spectrum, passband, [&](double wavenumber) { return wavenumber_radiance(temperature, wavenumber); });
    const double seen = weighted_integral(spectrum, passband, [&](double wavenumber) {
        return wavenumber_radiance(temperature, wavenumber) * value_at(spectrum, wavenumber);
    });
    if (!(whole > 0))
        throw Error(formatted("a black body of %g K has no radiance in %s", temperature,
                              passband.description().c_str()),
                    "-weight gives another temperature");
    return seen / whole;
}

}  // namespace infra::ir
