// From the files of atmosphere codes to domes and paths.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/air.h"
#include "ir/genirsky/dome.h"
#include "ir/genirsky/request.h"
#include "ir/genirsky/tape7.h"

namespace infra::ir {

/// All runs of all files, file by file. throws Error as read_tape7()
std::vector<Tape7Run> read_runs(const std::vector<std::string>& files);

/// Radiances seen along the runs, linear in the angle between them and constant beyond them.
///   angles_deg  from the pole, one a run, in any order
///   throws      Error for another number of angles, fewer than 2, an angle twice, runs without radiance, and
///   as
///               band_integral()
Dome dome_of_runs(const std::vector<Tape7Run>& runs, const std::vector<double>& angles_deg,
                  const Passband& passband);

/// Radiances of a sky (umu < 0) or a sea (umu > 0). Angles from the pole are arccos |umu|; linear between
/// them, constant beyond. Several phi make 210 values: a view's azimuth is phi + 180, clockwise from north,
/// which is azimuth 0 of the dome; values are linear between azimuths, around the circle, or, where all phi
/// are within 0..180 and both ends given, mirrored.
///   throws  Error for fewer than 2 usable umu, and as band_integral()
Dome dome_of_uvspec(const std::vector<UvspecRadiance>& radiances, bool sky, const Passband& passband);

/// One row a run, in the order of ranges_m. throws Error for another number of ranges, and as band_mean()
std::vector<AirRow> air_of_runs(const std::vector<Tape7Run>& runs, const Request& request);
/// The same for files of columns, one a range.
std::vector<AirRow> air_of_columns(const Request& request);

}  // namespace infra::ir
