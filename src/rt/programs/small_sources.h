// Light sources smaller than the distance between samples, which the rays of pixels would meet by chance:
// they are left out of the pixels' rays and painted over the picture, by the share of each pixel that they
// cover.
//
// source: what RADIANCE does likewise, rpict's SmallSourceDrawing.
#pragma once

#include <array>
#include <vector>

#include "rt/programs/pixel_tracer.h"

namespace infra {

using ImagePoint = std::array<double, 2>;  ///< in pixels, from the lower left corner of the picture
using ImagePolygon = std::vector<ImagePoint>;

/// Area of a convex polygon, in pixels.
double polygon_area(const ImagePolygon& polygon);
/// The part of a convex polygon within a rectangle.
ImagePolygon clipped(const ImagePolygon& polygon, double x0, double y0, double x1, double y1);
/// The least distance of two parallel lines that a convex polygon lies between.
double polygon_width(const ImagePolygon& polygon);

struct SmallSource {
    int source = -1;       ///< number in the scene
    ImagePolygon outline;  ///< convex, of the same area as the source's own
    bool is_exact = true;  ///< otherwise its true outline is another one
};

/// Sources of a scene that are to be painted. Illums, images in mirrors and sources that are cut by the
/// clipping planes or whose place in the view is not one piece are none.
///   spacing  of samples, in pixels: no wider ones are taken
std::vector<SmallSource> find_small_sources(const CompiledScene& scene, const View& view, int width,
                                            int height, int spacing);

/// Adds the sources to a frame whose pixels show what is behind them. What something hides, clear or not, is
/// left to the rays of pixels. The frame's distances become those of the nearest source in the pixel.
///   first_row  rows above it are left alone
void paint_small_sources(const std::vector<SmallSource>& sources, const View& view, Tracer& tracer,
                         int first_row, Frame& frame);

}  // namespace infra
