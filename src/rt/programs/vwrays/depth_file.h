// The distances of a picture's pixels, as rpict -z writes them: raw floats in the order of the pixels.
#pragma once

#include <string>
#include <vector>

#include "common/pictures/scan_order.h"

namespace infra {

class DepthFile {
  public:
    /// throws  Error for a missing file, and one of another size than the picture's
    DepthFile(const std::string& path, const ScanOrder& order);

    /// Distance at a place in pixels from the lower left corner.
    ///   throws  Error outside the picture
    float at(double x, double y) const;

  private:
    ScanOrder order_;
    std::vector<float> depths_;
};

}  // namespace infra
