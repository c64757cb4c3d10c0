// What a picture file says before its pixels: header, size, order of pixels.
#pragma once

#include <string>

#include "common/pictures/picture.h"
#include "common/pictures/scan_order.h"

namespace infra {

struct PictureLayout {
    PictureHeader header;
    ScanOrder order;
};

/// Reads the beginning of a RADIANCE picture (any format: colors, spectra, RADIANCE's other matrices with a
/// resolution line) or of OpenEXR.
///   throws  Error for a missing file, or one that begins as neither
PictureLayout read_picture_layout(const std::string& path);

}  // namespace infra
