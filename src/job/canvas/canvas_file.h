// The canvas of a job: a rectangle, or the silhouette in an SVG or image file.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "job/job_file.h"

namespace tessera {

/// The longest side that the page is drawn with for its edge (canvas_edge.h), where the canvas does not ask for more.
inline constexpr int kEdgeSide_px = 4096;

/// A mask is scaled into the box of the spec's size with its aspect kept; the canvas is then as large as the scaled
/// page, which touches the box in width or height. Zones to keep out of are taken out of it (canvas_keep_out.h). The
/// files are drawn in a process with limits (drawers.h). Throws
/// InputError where the file is no artwork, breaks a limit, becomes narrower than 16 px, or leaves nothing to fill.
/// `seconds` is how long each of its two drawings at most may take.
Canvas load_canvas(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing);

/// The same, drawn by the caller's drawers, which the caller may stop.
Canvas load_canvas(const CanvasSpec& spec, Drawers& drawers);

/// That of the job, whose path messages begin with.
Canvas canvas_of(const Job& job);
/// For drawers of the canvas' files, with pages of `side_px` at least.
DrawerSettings canvas_drawer_settings(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing,
                                      int side_px = kEdgeSide_px);

/// Half transparent or more somewhere, the rim apart: drawing blurs the edge of an opaque page.
bool has_transparency(const cv::Mat& page);

/// Throws InputError where the images beside a seamless canvas make it larger than a canvas may be.
void check_images(const Canvas& canvas, const PieceSettings& pieces);

/// The region in a page of straight BGRA, as coverage 0..1 of each pixel: the alpha where the page is transparent
/// anywhere, translucent parts with an edge counting wholly; else what differs from the colour that prevails along its
/// edge (mask.h).
Grid<float> mask_coverage(const cv::Mat& page);

/// What of the page is the canvas of this spec: by the colours of its regions, or as mask_coverage says.
Grid<float> canvas_coverage(const cv::Mat& page, const CanvasSpec& spec);

}  // namespace tessera
