// The parts of genirsky's option tables.
#pragma once

#include "common/options.h"
#include "ir/genirsky/request.h"

namespace infra::ir {

/// `request` must outlive the table and stay where it is.
void add_band_options(OptionTable& table, Request& request);
void add_output_options(OptionTable& table, Request& request);
/// Values of skies and seas by direction.
void add_dome_options(OptionTable& table, Request& request);
void add_plane_options(OptionTable& table, Request& request);
/// Spectra by direction or range.
void add_tape7_option(OptionTable& table, Request& request);
void add_uvspec_options(OptionTable& table, Request& request);
void add_sun_options(OptionTable& table, Request& request);
void add_air_options(OptionTable& table, Request& request);

}  // namespace infra::ir
