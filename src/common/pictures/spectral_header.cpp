#include "common/pictures/spectral_header.h"

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

std::string range_in_um(double shortest_nm, double longest_nm) {
    return formatted("%.9g-%.9g um", shortest_nm / 1000, longest_nm / 1000);
}

}  // namespace

std::string wavelength_splits_line(const Channels& channels) {
    const bool colors = channels.shows_colors();
    const double longest = channels.longest_nm(), range = channels.shortest_nm() - longest;
    const double red_from = colors ? Channels::red_from_nm : longest + range / 3;
    const double green_from = colors ? Channels::green_from_nm : longest + range * 2 / 3;
    return formatted("WAVELENGTH_SPLITS= %.10g %.10g %.10g %.10g", longest, red_from, green_from,
                     channels.shortest_nm());
}

std::string band_in_um(const Channels& channels) {
    return range_in_um(channels.shortest_nm(), channels.longest_nm());
}

std::string band_in_um(const Channels& channels, int c) {
    return range_in_um(channels.lower_nm(c), channels.upper_nm(c));
}

void set_channel_lines(PictureHeader& header, const Channels& channels) {
    std::erase_if(header.lines, [](const std::string& line) {
        return line.starts_with("NCOMP=") || line.starts_with("WAVELENGTH_SPLITS=");
    });
    if (channels.is_rgb()) return;
    header.add(formatted("NCOMP=%d", channels.count()));
    header.add(wavelength_splits_line(channels));
}

std::optional<Channels> channels_of(const PictureHeader& header, int count) {
    const auto words = split_words(header.value("WAVELENGTH_SPLITS").value_or(""));
    double longest = 0, shortest = 0;
    if (words.size() != 4 || !parse_real(words[0], longest) || !parse_real(words[3], shortest))
        return std::nullopt;
    try {
        return Channels::spectral(count, longest, shortest);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace infra
