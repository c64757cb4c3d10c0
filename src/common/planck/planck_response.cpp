#include "common/planck/planck_response.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/planck/planck_integral.h"
#include "common/planck/planck_inverse.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra {
namespace {

using Sample = SpectralResponse::Sample;

Sample parse_sample(const std::vector<std::string>& words, const Location& place) {
    if (words.size() != 2)
        throw Error(place, formatted("expected 2 columns, found %zu", words.size()),
                    "a line is a wavelength in um and a weight");
    double numbers[2] = {};
    for (int i = 0; i < 2; ++i)
        if (!parse_real(words[i], numbers[i])) throw Error(place, "\"" + words[i] + "\" is not a number");
    return {numbers[0], numbers[1]};
}

void check_sample(const Sample& sample, const std::vector<Sample>& before, const Location& place) {
    if (sample.wavelength_um < shortest_wavelength_um || sample.wavelength_um > longest_wavelength_um)
        throw Error(place,
                    formatted("wavelength %g um is not within %g..%g um", sample.wavelength_um,
                              shortest_wavelength_um, longest_wavelength_um),
                    "wavelengths are in micrometres");
    if (!before.empty() && sample.wavelength_um <= before.back().wavelength_um)
        throw Error(place, formatted("wavelength %g um does not come after %g um", sample.wavelength_um,
                                     before.back().wavelength_um));
    if (sample.weight < 0) throw Error(place, formatted("weight %g is negative", sample.weight));
}

/// One segment's part of the integrals at a temperature.
PlanckIntegral segment_integral(const Sample& first, const Sample& last, double temperature) {
    const double scale = constants::second_radiation_um / temperature;
    const double gradient = (last.weight - first.weight) / (last.wavelength_um - first.wavelength_um);
    const double intercept = first.weight - gradient * first.wavelength_um;
    // What lies further than this from the segment's long-wave end is e^-60 of it.
    constexpr double farthest = 60.0;
    const double from = scale / last.wavelength_um;
    const double to = std::min(scale / first.wavelength_um, from + farthest);
    return planck_quadrature(from, to, [&](double x) { return intercept + gradient * scale / x; });
}

}  // namespace

SpectralResponse::SpectralResponse(std::vector<Sample> samples, std::string name)
    : samples_(std::move(samples)), name_(std::move(name)) {}

SpectralResponse SpectralResponse::read(const std::string& path) {
    return parse(read_text_file(path), path == "-" ? "standard input" : path);
}

SpectralResponse SpectralResponse::parse(std::string_view text, const std::string& name) {
    std::vector<Sample> samples;
    Location place{name, 0};
    while (!text.empty()) {
        ++place.line;
        const std::string_view line = take_line(text);
        const std::vector<std::string> words = split_words(line.substr(0, line.find('#')));
        if (words.empty()) continue;
        const Sample sample = parse_sample(words, place);
        check_sample(sample, samples, place);
        samples.push_back(sample);
    }
    place.line = std::max(place.line, 1);
    if (samples.size() < 2)
        throw Error(place, formatted("a response needs at least 2 samples, found %zu", samples.size()),
                    "a line is a wavelength in um and a weight");
    if (std::ranges::all_of(samples, [](const Sample& sample) { return sample.weight == 0; }))
        throw Error(place, "all weights are 0");
    return {std::move(samples), name};
}

ThermalRadiance SpectralResponse::thermal_radiance(double temperature) const {
    check_temperature(temperature);
    PlanckIntegral sum;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        if (samples_[i - 1].weight == 0 && samples_[i].weight == 0) continue;
        const PlanckIntegral part = segment_integral(samples_[i - 1], samples_[i], temperature);
        sum.energy += part.energy;
        sum.slope += part.slope;
    }
    const double scale = constants::radiance_factor * temperature * temperature * temperature;
    return {scale * temperature * sum.energy, scale * sum.slope};
}

double SpectralResponse::temperature(double radiance) const {
    return invert_radiance([this](double kelvin) { return thermal_radiance(kelvin); }, radiance);
}

}  // namespace infra
