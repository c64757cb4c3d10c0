// Tables of several bands that make one material, and what each channel of a rendering takes from them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/spectra/channels.h"
#include "nrlbrdf/table_file.h"

namespace infra {

/// Sorts the tables by wavelength, the longest first as channels are, and checks that they can stand
/// together: one table, or several of equal grids, each with a band, no two of which overlap.
///   throws  infra::Error with the file and line of the table that does not fit
void order_table_set(std::vector<LoadedTable>& tables);

/// Shares of the tables in a channel, adding up to 1.
using TableShares = std::vector<double>;

/// What every channel is made of.
struct ChannelShares {
    std::vector<TableShares> of_channel;
    std::vector<int> without_band;  ///< channels that no band overlaps: they take the nearest band

    /// The table that is all of every channel; -1 when there is none.
    int only_table() const;
};

/// Shares by the width that channel and band have in common. A single table is all of every channel.
///   tables  as order_table_set leaves them; several only for spectral channels
ChannelShares share_tables(const Channels& channels, std::span<const LoadedTable> tables);

/// A sentence that names the channels without a band of their own; empty when there are none.
std::string describe_gaps(const Channels& channels, const ChannelShares& shares);

}  // namespace infra
