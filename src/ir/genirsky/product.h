// From a request to the file that answers it.
#pragma once

#include <string>

#include "ir/genirsky/request.h"

namespace infra::ir {

/// The whole file, with comments that say how it was made: command line, quantity, band, unit, sources.
/// throws Error for what is wrong with the files that the request names
std::string product_text(const Request& request);

}  // namespace infra::ir
