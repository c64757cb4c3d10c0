// What genirsky's command line asks for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/spectra/channels.h"
#include "ir/genirsky/dome_file.h"
#include "ir/genirsky/frame.h"
#include "ir/genirsky/passband.h"
#include "ir/genirsky/sea_plane.h"
#include "ir/genirsky/sun.h"
#include "ir/genirsky/uvspec.h"

namespace infra::ir {

enum class Subject { sky, sea, sun, air };

/// Where values come from.
enum class Source { none, elevations, table, thrend, plane, tape7, uvspec, homogeneous };

struct Request {
    Subject subject = Subject::sky;
    std::string command;  ///< the command line, for the comments

    Source source = Source::none;
    std::string source_option;       ///< that chose it
    std::vector<std::string> files;  ///< several only for tape7 and uvspec
    std::optional<ValueUnit> value_unit;
    bool from_horizon = false;
    std::vector<double> angles_deg;  ///< from the pole, one a run
    UvspecLayout uvspec;
    Sensor sensor;                  ///< of plane
    std::optional<double> horizon;  ///< of plane: value of the last row, in value_unit

    /// Of one band or response, or of channels, longest wavelengths first; empty: not stated.
    std::vector<Passband> passbands;
    std::optional<Channels> channels;
    int channel_count = 0;                                   ///< as typed, 0: not given
    std::optional<std::pair<double, double>> channel_range;  ///< nm, as typed

    Sun sun;
    std::optional<std::pair<double, double>> sun_angles;  ///< altitude and azimuth, degrees
    bool sun_direction = false;                           ///< given as a vector

    double air_temperature = 0;       ///< K, of homogeneous
    double air_extinction = 0;        ///< per metre
    std::vector<double> ranges_m;     ///< one a run
    double weight_temperature = 300;  ///< K, of the black body that weights transmittances

    Frame frame;
    std::string name;    ///< of the source primitive and the beginning of the others' names
    std::string output;  ///< empty: standard output

    std::string name_of_subject() const;
    /// A channel's value over the radiance in its band, see common/spectra/channels.h.
    double channel_factor() const { return channels ? channels->count() : 1; }
};

/// Nothing when -help, -defaults or -version was answered. throws Error for a bad command line.
std::optional<Request> read_request(int argc, char** argv);

}  // namespace infra::ir
