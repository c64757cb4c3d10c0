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
    channels.bands_ = count;
    channels.rgb_ = false;
    channels.longest_ = std::max(nm_a, nm_b);
    channels.shortest_ = std::min(nm_a, nm_b);
    return channels;
}

Channels Channels::with_components(int components) const {
    if (components < 1 || components > Spectrum::max_channels / bands_)
        throw Error(formatted("%d components of %d channels are too many", components, bands_),
                    formatted("at most %d values in all", Spectrum::max_channels));
    Channels channels = *this;
    channels.components_ = components;
    return channels;
}

Channels Channels::one_component() const {
    Channels channels = *this;
    channels.components_ = 1;
    return channels;
}

bool Channels::shows_colors() const { return shortest_ < blue_peak_nm && longest_ > red_peak_nm; }

int Channels::primary_of(int c) const {
    const int band = band_of(c);
    if (bands_ == 3) return band;
    if (!shows_colors()) return 3 * (2 * band + 1) / (2 * bands_);  // by the middle of the channel
    const double center = center_nm(band);
    return center >= red_from_nm ? 0 : center >= green_from_nm ? 1 : 2;
}

Spectrum Channels::from_rgb(double red, double green, double blue) const {
    const double rgb[3] = {red, green, blue};
    Spectrum result(count());
    for (int c = 0; c < count(); ++c) result.set(c, static_cast<float>(rgb[primary_of(c)]));
    return result;
}

Spectrum Channels::in_all_components(const Spectrum& bands) const {
    if (components_ == 1) return bands;
    Spectrum result(count());
    for (int c = 0; c < count(); ++c) result.set(c, bands[band_of(c)]);
    return result;
}

Spectrum Channels::in_component(int component, const Spectrum& all) const {
    if (components_ == 1) return all;
    Spectrum result(count());
    for (int c = component * bands_; c < (component + 1) * bands_; ++c) result.set(c, all[c]);
    return result;
}

std::string Channels::description() const {
    if (rgb_) return "RGB";
    return formatted("%d channels of %g-%g nm", bands_, shortest_, longest_);
}

}  // namespace infra
