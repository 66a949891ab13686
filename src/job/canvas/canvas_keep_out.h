// The keep-out zones of a job's canvas: rectangles, and what the file of canvas.keep_out shows.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

/// Removes the keep-out zones of the spec from the canvas. The file is read like canvas.file (mask_coverage). Throws
/// InputError where the file is no artwork, exceeds a limit or shows nothing, and where nothing is left of the canvas.
void take_out_zones(const CanvasSpec& spec, Drawers& drawers, Canvas& canvas);

/// The place of a page of this size in canvas px: centred, and as large as its aspect ratio allows.
cv::Rect2d place_on_canvas(cv::Size2d page, const Canvas& canvas);

}  // namespace tessera
