#include "rt/programs/vwrays/depth_file.h"

#include <cmath>
#include <cstring>

#include "common/error.h"
#include "common/format.h"
#include "common/text_file.h"

namespace infra {

DepthFile::DepthFile(const std::string& path, const ScanOrder& order) : order_(order) {
    const std::string bytes = read_text_file(path);
    const std::size_t pixels = std::size_t(order.width) * static_cast<std::size_t>(order.height);
    if (bytes.size() != pixels * sizeof(float))
        throw Error(Location{path},
                    formatted("%zu bytes are not the distances of %d x %d pixels", bytes.size(), order.width,
                              order.height),
                    "a file of rpict -z has one float a pixel");
    depths_.resize(pixels);
    std::memcpy(depths_.data(), bytes.data(), bytes.size());
}

float DepthFile::at(double x, double y) const {
    if (!(x >= 0 && x < order_.width && y >= 0 && y < order_.height))
        throw Error(Location{"standard input"},
                    formatted("pixel %g %g lies outside the picture", x - 0.5, y - 0.5));
    const PixelPlace place{static_cast<int>(x), order_.height - 1 - static_cast<int>(y)};
    return depths_[static_cast<std::size_t>(order_.index(place))];
}

}  // namespace infra
