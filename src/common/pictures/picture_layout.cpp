#include "common/pictures/picture_layout.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "common/error.h"
#include "common/pictures/exr_info.h"

namespace infra {
namespace {

constexpr std::size_t longest_header = 1 << 22;  // bytes

PictureLayout layout_of_exr(const std::string& path) {
    ExrInfo info = read_exr_info(path);
    PictureLayout layout;
    layout.header.lines = std::move(info.lines);
    layout.order.width = info.width;
    layout.order.height = info.height;
    return layout;
}

}  // namespace

PictureLayout read_picture_layout(const std::string& path) {
    if (is_exr_file(path)) return layout_of_exr(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(Location{path}, std::string("cannot open picture: ") + std::strerror(errno));
    PictureLayout layout;
    std::string line;
    std::size_t size = 0;
    if (!std::getline(file, line) || !line.starts_with("#?"))
        throw Error(Location{path}, "not a picture", "it does not start with \"#?\"");
    while (std::getline(file, line) && !line.empty() && (size += line.size()) < longest_header)
        layout.header.add(line);
    const bool complete = static_cast<bool>(std::getline(file, line));
    const auto order = complete ? parse_scan_order(line) : std::nullopt;
    if (!order) throw Error(Location{path}, "bad picture: no resolution line such as \"-Y 480 +X 640\"");
    layout.order = *order;
    return layout;
}

}  // namespace infra
