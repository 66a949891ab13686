// The canvas of a job: a rectangle, or the silhouette in an SVG or image file.
#pragma once

#include <opencv2/core.hpp>

#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "io/drawing/drawers.h"
#include "io/job/job_file.h"

namespace tessera::io {

/// A mask is scaled into the box of the spec's size with its aspect kept; the canvas is then as large as the scaled
/// page, which touches the box in width or height. The file is drawn in a process with limits (drawers.h). Throws
/// InputError where the file is no artwork, breaks a limit, becomes narrower than 16 px, or leaves nothing to fill.
/// `seconds` is how long each of its two drawings at most may take.
Canvas load_canvas(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing);

/// The same, drawn by the caller's drawers, which the caller may stop.
Canvas load_canvas(const CanvasSpec& spec, Drawers& drawers);
DrawerSettings canvas_drawer_settings(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing);

/// Throws InputError where a picture of that width would become higher than the widest one may be, or, on a canvas that
/// is seamless from top to bottom, not a whole number of px high.
void check_picture_height(const OutputSpec& output, const Canvas& canvas);

/// Throws InputError where the images beside a seamless canvas make it larger than a canvas may be.
void check_images(const Canvas& canvas, const PieceSettings& pieces);

/// The region in a page of straight BGRA, as coverage 0..1 of each pixel, the sizes rounded up to even ones: the alpha
/// where the page is transparent anywhere, else what differs from the colour that prevails along its edge (mask.h).
Grid<float> mask_coverage(const cv::Mat& page);

}  // namespace tessera::io
