#include "ir/genirsky/atmosphere.h"

#include <algorithm>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {
namespace {

void check_number(std::size_t runs, std::size_t given, const char* what, const char* option) {
    if (runs != given)
        throw Error(formatted("the files hold %zu runs, but %zu %s are given", runs, given, what),
                    std::string(option) + ", one for each run in the order of the files");
}

AirValue air_value(const SampledSpectrum& transmittance, const SampledSpectrum& radiance,
                   const Passband& passband, double temperature) {
    return {band_mean(transmittance, passband, temperature), band_integral(radiance, passband)};
}

}  // namespace

std::vector<Tape7Run> read_runs(const std::vector<std::string>& files) {
    std::vector<Tape7Run> runs;
    for (const std::string& file : files)
        for (Tape7Run& run : read_tape7(file)) runs.push_back(std::move(run));
    return runs;
}

Dome dome_of_runs(const std::vector<Tape7Run>& runs, const std::vector<double>& angles_deg,
                  const Passband& passband) {
    check_number(runs.size(), angles_deg.size(), "angles", "-angles");
    if (runs.size() < 2) throw Error("one run is no sky: at least 2 angles are needed");
    std::vector<AngleSample> samples;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].require_radiance();
        samples.push_back({angles_deg[i], band_integral(runs[i].total_radiance, passband)});
    }
    std::ranges::sort(samples, {}, &AngleSample::angle_deg);
    const auto twice = std::ranges::adjacent_find(samples, {}, &AngleSample::angle_deg);
    if (twice != samples.end()) throw Error(formatted("-angles names %g deg twice", twice->angle_deg));
    return {at_rows(samples)};
}

std::vector<AirRow> air_of_runs(const std::vector<Tape7Run>& runs, const Request& request) {
    check_number(runs.size(), request.ranges_m.size(), "ranges", "-ranges");
    std::vector<AirRow> rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].require_radiance();
        rows.push_back({request.ranges_m[i], {}});
        for (const Passband& passband : request.passbands)
            rows[i].values.push_back(air_value(runs[i].transmittance, runs[i].path_radiance, passband,
                                               request.weight_temperature));
    }
    return rows;
}

std::vector<AirRow> air_of_columns(const Request& request) {
    check_number(request.files.size(), request.ranges_m.size(), "ranges", "-ranges");
    std::vector<AirRow> rows;
    for (std::size_t i = 0; i < request.files.size(); ++i) {
        const PathSpectra spectra = parse_path_columns(read_numbers(request.files[i]), request.uvspec);
        rows.push_back({request.ranges_m[i], {}});
        for (const Passband& passband : request.passbands)
            rows[i].values.push_back(
                air_value(spectra.transmittance, spectra.radiance, passband, request.weight_temperature));
    }
    return rows;
}

}  // namespace infra::ir
