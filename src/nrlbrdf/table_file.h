// Reader of .brdf files, the tables of the `nrlbrdf` primitive.
//
//   # comment                      to the end of the line, anywhere
//   #% phi 180                     rows cover 0..180 deg, both ends included; the other half mirrors them
//   #% mirror 0                    the mirror direction is phi = 0 (without it, 180 deg)
//   #% band 8 9                    wavelengths in um that the table stands for (without it, any)
//   Ni Np Nt                       counts of theta_i, phi and theta_r, each >= 2
//   [D] block_1 ... [D] block_Ni   one block per theta_i; Np rows of Nt values f [1/sr] each
//
// After its last number may follow another `#% band`, with directives, counts and values of its own: so files
// of one band each make one of several when they are joined.
//
// The values are the whole BRDF. D, the diffuse reflectance they contain, stands once after the counts or
// before every block, and must fit under the data it heads: D <= pi min f. What is used is the largest that
// fits (see table.h). The writer is models.h's write_table.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"
#include "nrlbrdf/table.h"
#include "nrlbrdf/wavelength_band.h"

namespace infra {

/// Most values a table may have: a guard against absurd counts, 400 MB.
inline constexpr std::size_t max_table_values = 100'000'000;

/// A table ready for use and what the user should know about it.
struct LoadedTable {
    std::shared_ptr<const BrdfTable> table;
    std::optional<WavelengthBand> band;
    Location place;                     ///< where it says its band, or starts
    std::vector<std::string> warnings;  ///< complete lines, "file:line: ..."; the caller prints them
};

/// Reads and checks a file of one table or more. Warns where a directional-hemispherical reflectance is
/// over 1.
///   throws  infra::Error with file, line and the offending angle
std::vector<LoadedTable> load_tables(const std::string& path);

/// The same for a file that must hold one table only.
LoadedTable load_table(const std::string& path);

/// The grid of a file of one table, all of 0..360 deg in phi.
BrdfGrid read_table_file(const std::string& path);

/// The same from text in memory; `name` stands for the file in errors.
BrdfGrid parse_table(std::string_view text, const std::string& name);

}  // namespace infra
