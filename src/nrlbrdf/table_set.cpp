#include "nrlbrdf/table_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/format.h"

namespace infra {
namespace {

WavelengthBand band_of(const Channels& channels, int c) {
    return {channels.lower_um(c), channels.upper_um(c)};
}

std::string place_text(const Location& place) { return place.file + ":" + std::to_string(place.line); }

std::string grid_text(const GridShape& shape) {
    return formatted("%d x %d x %d%s", shape.theta_i_count, shape.phi_count, shape.theta_r_count,
                     shape.phi_origin != 0 ? " with the mirror direction at 0" : "");
}

std::string regridding_hint(const GridShape& shape) {
    return formatted("brdftab -table old.brdf -n %d %d %d -o new.brdf makes another grid",
                     shape.theta_i_count, shape.phi_count, shape.theta_r_count);
}

/// Distance from a wavelength to a band; 0 inside.
double distance(const WavelengthBand& band, double um) {
    return std::max({0.0, band.lo_um - um, um - band.hi_um});
}

}  // namespace

void order_table_set(std::vector<LoadedTable>& tables) {
    if (tables.size() < 2) return;
    const LoadedTable& first = tables.front();
    for (const LoadedTable& other : tables) {
        if (!other.band)
            throw Error(other.place, "this table states no band, and it is one of several",
                        "#% band lo hi, in um, stands before each of them");
        if (other.table->shape() != first.table->shape())
            throw Error(other.place,
                        "the grid, " + grid_text(other.table->shape()) + ", is not that of " +
                            place_text(first.place) + ", " + grid_text(first.table->shape()),
                        regridding_hint(first.table->shape()));
    }
    std::ranges::stable_sort(tables, std::greater{}, [](const LoadedTable& t) { return t.band->lo_um; });
    for (std::size_t n = 0; n + 1 < tables.size(); ++n)
        if (overlap(*tables[n].band, *tables[n + 1].band) > 0)
            throw Error(tables[n + 1].place, "band " + tables[n + 1].band->text() + " overlaps " +
                                                 tables[n].band->text() + " of " +
                                                 place_text(tables[n].place));
}

int ChannelShares::only_table() const {
    const TableShares& first = of_channel.front();
    const auto all = std::ranges::find(first, 1.0);
    const bool same = std::ranges::all_of(of_channel, [&](const TableShares& own) { return own == first; });
    return same && all != first.end() ? static_cast<int>(all - first.begin()) : -1;
}

ChannelShares share_tables(const Channels& channels, std::span<const LoadedTable> tables) {
    ChannelShares shares;
    for (int c = 0; c < channels.count(); ++c) {
        TableShares& own = shares.of_channel.emplace_back(tables.size(), 0.0);
        if (!tables.front().band || channels.is_rgb()) {
            own.front() = 1;
            continue;
        }
        const WavelengthBand band = band_of(channels, c);
        double covered = 0;
        for (std::size_t t = 0; t < tables.size(); ++t) covered += own[t] = overlap(*tables[t].band, band);
        if (covered > 0) {
            for (double& share : own) share /= covered;
            continue;
        }
        const auto nearest = std::ranges::min_element(
            tables, {}, [&](const LoadedTable& t) { return distance(*t.band, band.center()); });
        own[static_cast<std::size_t>(nearest - tables.begin())] = 1;
        if (c < channels.bands()) shares.without_band.push_back(c);
    }
    return shares;
}

std::string describe_gaps(const Channels& channels, const ChannelShares& shares) {
    if (shares.without_band.empty()) return "";
    const int first = shares.without_band.front(), last = shares.without_band.back();
    return formatted("no band for %zu of the %d channels, between %g and %g um: they take the nearest one",
                     shares.without_band.size(), channels.bands(), channels.lower_um(last),
                     channels.upper_um(first));
}

}  // namespace infra
