// The air between the camera and what it sees: transmittance and path radiance over distance, from a file.
//
//     # from an atmosphere code; distances in the scene's unit of length
//     #% bands 8 10 12               edges in um: K + 1 edges make K bands
//     distance tau_1 Lp_1 ... tau_K Lp_K
//
// tau is the transmittance of a band up to the distance, Lp the radiance [W m^-2 sr^-1, in the band] that the
// air sends to the camera from as far as that. The first row may be at distance 0, where tau = 1 and Lp = 0;
// it is implied. Without `bands` there is one of unstated range. Between rows ln tau and the mean source
// function Lp / (1 - tau) are linear in distance, beyond the last row the former goes on as in the last
// interval and the latter stays: exact for homogeneous air of one temperature.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/spectra/channels.h"

namespace infra {

/// Immutable, so that threads share it.
class AirPath {
  public:
    /// Reads a file for these channels; the path "-" is the standard input.
    /// throws Error when it cannot be read, and as parse()
    static AirPath read(const std::string& path, const Channels& channels);

    /// name: for messages.
    /// throws Error with file and line for anything but numbers, distances that do not increase, tau outside
    /// 0..1 or growing, Lp negative or without absorption, a wrong number of columns, no rows, bands out of
    /// order, and bands that do not reach all channels
    static AirPath parse(std::string_view text, const std::string& name, const Channels& channels);

    /// The air between two distances from the camera, 0 <= near <= far, as seen at its near end: the share of
    /// a radiance behind it that gets through, and the radiance [as the channels'] that it adds.
    void stretch(double near, double far, Spectrum& transmittance, Spectrum& radiance) const;

    /// Edges of the file's bands in um, increasing; empty when it states none.
    const std::vector<double>& edges_um() const { return edges_um_; }

  private:
    struct Node {
        double distance;
        double depth;   ///< -ln tau
        double source;  ///< Lp / (1 - tau)
    };
    struct Share {
        int band;
        double of_channel;  ///< share of the channel's width that the band covers, all shares adding to 1
        double of_band;     ///< factor from the band's radiance to the channel's value
    };
    struct Point {
        double transmittance, radiance;
    };

    explicit AirPath(const Channels& channels) : shares_(static_cast<std::size_t>(channels.count())) {}
    Point band_at(int band, double distance) const;
    Point channel_at(int channel, double distance) const;
    void share_bands(const Channels& channels, const std::string& name);
    friend class AirPathReader;

    std::vector<double> edges_um_;
    std::vector<std::vector<Node>> bands_;    ///< by band, by row
    std::vector<std::vector<Share>> shares_;  ///< by channel
};

}  // namespace infra
