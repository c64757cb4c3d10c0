// What several of genirsky's options do with their arguments.
#pragma once

#include "common/options.h"
#include "ir/genirsky/request.h"

namespace infra::ir {

/// "0,30,60" as numbers; rejects anything else.
std::vector<double> number_list(const OptionValues& given);

/// The n-th value as a temperature, 0 < T <= hottest_temperature.
double kelvin(const OptionValues& given, std::size_t n);

/// Notes the source; rejects a second one, but for files of the same atmosphere code.
void choose_source(Request& request, const OptionValues& given, Source source);

}  // namespace infra::ir
