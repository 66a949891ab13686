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

/// Longest side, at least, of the page that is drawn for the canvas' edge (canvas_edge.h).
inline constexpr int kEdgeSide_px = 4096;

/// The canvas of a job. A mask is scaled into the box of the spec's size, keeping its aspect ratio; the canvas is as
/// large as the scaled page, which touches the box in width or height. Keep-out zones are removed (canvas_keep_out.h).
/// The files are drawn in a process with limits (drawers.h). Throws InputError where the file is no artwork, exceeds a
/// limit, becomes narrower than 16 px, or leaves nothing to fill. `seconds`: time limit for each of the two drawings.
Canvas load_canvas(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing);

/// Loads the canvas with the caller's drawers, which the caller may stop.
Canvas load_canvas(const CanvasSpec& spec, Drawers& drawers);

/// The canvas of the job; error messages begin with the job's path.
Canvas canvas_of(const Job& job);
/// Settings of drawers for the canvas' files, with pages of at least `side_px`.
DrawerSettings canvas_drawer_settings(const CanvasSpec& spec, double seconds = DrawerSettings{}.seconds_per_drawing,
                                      int side_px = kEdgeSide_px);

/// Whether any pixel inside the rim is at least half transparent. The rim does not count: drawing blurs the edge of an
/// opaque page.
bool has_transparency(const cv::Mat& page);

/// Throws InputError where a seamless canvas with the images beside it is larger than a canvas may be.
void check_images(const Canvas& canvas, const PieceSettings& pieces);

/// The area that a page of straight BGRA shows, as coverage 0..1 of each pixel. Where the page has transparency it is
/// the alpha, and translucent parts with an edge count fully. Otherwise it is what differs from the prevailing colour
/// along the page's edge (mask.h).
Grid<float> mask_coverage(const cv::Mat& page);

/// The part of the page that is the canvas: by the colours of its regions, or by mask_coverage.
Grid<float> canvas_coverage(const cv::Mat& page, const CanvasSpec& spec);

}  // namespace tessera
