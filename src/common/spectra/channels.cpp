#include "common/spectra/channels.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"

namespace infra {
namespace {

constexpr double shortest_sensible_nm = 100;             // smaller numbers are um
constexpr double red_peak_nm = 607, blue_peak_nm = 469;  // a range within these shows less than three

}  // namespace

Channels Channels::spectral(int count, double nm_a, double nm_b) {
    if (count < fewest || count > most)
        throw Error(formatted("%d spectral channels are not supported", count),
                    formatted("from %d to %d", fewest, most));
    if (!(nm_a > 0) || !(nm_b > 0) || std::isinf(nm_a) || std::isinf(nm_b) || nm_a == nm_b)
        throw Error(formatted("%g to %g nm is not a range of wavelengths", nm_a, nm_b));
    if (std::max(nm_a, nm_b) < shortest_sensible_nm)
        throw Error(formatted("%g to %g nm is not a range of wavelengths", nm_a, nm_b),
                    "they are in nanometres: 8 um is 8000");
    Channels channels;
    channels.count_ = count;
    channels.rgb_ = false;
    channels.longest_ = std::max(nm_a, nm_b);
    channels.shortest_ = std::min(nm_a, nm_b);
    return channels;
}

bool Channels::shows_colors() const { return shortest_ < blue_peak_nm && longest_ > red_peak_nm; }

int Channels::primary_of(int c) const {
    if (count_ == 3) return c;
    if (!shows_colors()) return 3 * (2 * c + 1) / (2 * count_);  // by the middle of the channel
    const double center = center_nm(c);
    return center >= red_from_nm ? 0 : center >= green_from_nm ? 1 : 2;
}

Spectrum Channels::from_rgb(double red, double green, double blue) const {
    const double rgb[3] = {red, green, blue};
    Spectrum result(count_);
    for (int c = 0; c < count_; ++c) result.set(c, static_cast<float>(rgb[primary_of(c)]));
    return result;
}

std::string Channels::description() const {
    if (rgb_) return "RGB";
    return formatted("%d channels of %g-%g nm", count_, shortest_, longest_);
}

}  // namespace infra
