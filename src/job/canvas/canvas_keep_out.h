// The zones of a job's canvas that pieces keep out of: rectangles, and what the file of canvas.keep_out shows.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

/// Takes the zones of the spec out of its canvas. What the file shows is read as canvas.file is (mask_coverage). Throws
/// InputError where the file is no artwork, breaks a limit or shows nothing, and where nothing is left of the canvas.
void take_out_zones(const CanvasSpec& spec, Drawers& drawers, Canvas& canvas);

/// Where a page of this size lies on the canvas, in px of it: as large as its aspect allows, in the middle.
cv::Rect2d place_on_canvas(cv::Size2d page, const Canvas& canvas);

}  // namespace tessera
