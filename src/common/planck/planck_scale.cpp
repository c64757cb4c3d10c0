#include "common/planck/planck_scale.h"

#include <algorithm>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"

namespace infra {
namespace {

template <class Function>
void map_values(std::span<const double> values, std::span<double> results, Function function) {
    if (values.size() != results.size())
        throw Error(formatted("%zu values cannot give %zu results", values.size(), results.size()), {},
                    Severity::internal);
    for (std::size_t i = 0; i < values.size(); ++i) {
        try {
            results[i] = function(values[i]);
        } catch (const Error& error) {
            throw Error(formatted("value %zu: ", i + 1) + error.message(), error.hint(), error.severity());
        }
    }
}

}  // namespace

RadianceScale RadianceScale::of_band(double lo_um, double hi_um) {
    check_band(lo_um, hi_um);
    if (lo_um < shortest_wavelength_um || hi_um > longest_wavelength_um)
        throw Error(formatted("band %g..%g um is not within %g..%g um", lo_um, hi_um, shortest_wavelength_um,
                              longest_wavelength_um),
                    "wavelengths are in micrometres");
    return RadianceScale(Band(lo_um, hi_um));
}

RadianceScale RadianceScale::of_response(SpectralResponse response) {
    return RadianceScale(std::move(response));
}

RadianceScale RadianceScale::parse(const std::string& text) {
    std::string spaced = text;
    for (const std::string_view separator : {"..", "-"}) {
        const std::size_t at = spaced.find(separator, 1);
        if (at == std::string::npos) continue;
        spaced.replace(at, separator.size(), " ");
        break;
    }
    std::vector<std::string> words = split_words(spaced);
    if (words.size() == 3 && (words[2] == "um" || words[2] == "µm")) words.pop_back();
    double lo = 0, hi = 0;
    if (words.size() != 2 || !parse_real(words[0], lo) || !parse_real(words[1], hi))
        throw Error("\"" + text + "\" is not a band", "as in \"8-12 um\"");
    return of_band(lo, hi);
}

ThermalRadiance RadianceScale::at(double temperature) const {
    if (const Band* band = std::get_if<Band>(&law_))
        return band_thermal_radiance(temperature, band->first, band->second);
    return std::get<SpectralResponse>(law_).thermal_radiance(temperature);
}

double RadianceScale::temperature(double radiance) const {
    if (const Band* band = std::get_if<Band>(&law_))
        return band_temperature(radiance, band->first, band->second);
    return std::get<SpectralResponse>(law_).temperature(radiance);
}

void RadianceScale::radiances(std::span<const double> temperatures, std::span<double> results) const {
    map_values(temperatures, results, [this](double kelvin) { return at(kelvin).radiance; });
}

void RadianceScale::slopes(std::span<const double> temperatures, std::span<double> results) const {
    map_values(temperatures, results, [this](double kelvin) { return at(kelvin).slope; });
}

void RadianceScale::temperatures(std::span<const double> radiances, std::span<double> results) const {
    map_values(radiances, results, [this](double radiance) { return temperature(radiance); });
}

std::string RadianceScale::description() const {
    if (const Band* band = std::get_if<Band>(&law_))
        return formatted("%.9g-%.9g um", band->first, band->second);
    return "response " + std::get<SpectralResponse>(law_).name();
}

}  // namespace infra
