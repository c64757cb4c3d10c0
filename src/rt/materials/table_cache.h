// BRDF tables by file: materials that name the same file share the table and its distribution.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "nrlbrdf/distribution.h"

namespace infra {

struct TableCache {
    std::map<std::string, std::shared_ptr<const TableDistribution>, std::less<>> by_path;
};

}  // namespace infra
