// The resolution line of RADIANCE's pictures, "-Y 480 +X 640": size, and the order in which pixels are
// stored.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace infra {

struct PixelPlace {
    int column = 0;  ///< from the left
    int row = 0;     ///< from the top
};

struct ScanOrder {
    int width = 0, height = 0;
    bool y_major = true;  ///< scanlines are rows; otherwise columns
    bool x_decreases = false, y_decreases = true;

    int scanline_length() const { return y_major ? width : height; }
    int scanline_count() const { return y_major ? height : width; }
    /// From the top, each row from the left: the order of this library's pictures.
    bool is_standard() const { return y_major && y_decreases && !x_decreases; }
    /// Where pixel `step` of scanline `scan` lies.
    PixelPlace place(int scan, int step) const {
        const int x = y_major ? step : scan;
        const int y = y_major ? scan : step;
        return {x_decreases ? width - 1 - x : x, y_decreases ? y : height - 1 - y};
    }
    /// Position in the file, in pixels, of the one at this place.
    long long index(const PixelPlace& place) const {
        const long long x = x_decreases ? width - 1 - place.column : place.column;
        const long long y = y_decreases ? place.row : height - 1 - place.row;
        return y_major ? y * width + x : x * height + y;
    }
};

/// Whether a line names both axes, whatever sizes it gives them.
bool is_resolution_line(std::string_view text);

/// Reads "-Y height +X width" and its seven relatives; nothing for any other text, or a side that is not from
/// 1 to 2^20.
std::optional<ScanOrder> parse_scan_order(std::string_view text);

}  // namespace infra
