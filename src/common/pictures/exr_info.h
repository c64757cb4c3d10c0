// What an OpenEXR file says about itself, without its pixels.
#pragma once

#include <string>
#include <vector>

namespace infra {

struct ExrInfo {
    /// The lines of "radianceHeader", then "name=value" for the other attributes that are text, and
    /// "channels= " with the names of all channels.
    std::vector<std::string> lines;
    int width = 0;
    int height = 0;
};

/// Whether a file starts as OpenEXR does; not so one that cannot be opened.
bool is_exr_file(const std::string& path);

/// throws Error with the name for a file that is not OpenEXR or damaged
ExrInfo read_exr_info(const std::string& path);

}  // namespace infra
