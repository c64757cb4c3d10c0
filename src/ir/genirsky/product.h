// From a request to the file that answers it.
#pragma once

#include <string>
#include <vector>

#include "ir/genirsky/request.h"

namespace infra::ir {

struct Product {
    std::string text;                   ///< the whole file
    std::vector<std::string> warnings;  ///< lines about what looks like a slip
};

/// The file has comments that say how it was made: command line, quantity, band, unit, sources.
/// throws Error for what is wrong with the files that the request names
Product make_product(const Request& request);

}  // namespace infra::ir
