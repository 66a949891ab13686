// The drawing in a canvas file, as large as the canvas needs it.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "job/job_file.h"

namespace tessera {

/// The bytes of canvas.file, or of the file of another key. Throws InputError.
std::vector<std::uint8_t> read_canvas_file(const std::string& path, const char* key = "canvas.file");

struct CanvasPage {
  cv::Mat bgra;      // straight
  int width_px = 0;  // of the canvas
  int height_px = 0;
  int cells_per_px = 2;  // of coverage_on_canvas, both ways: the page is drawn so fine where it can be; else 1

  /// Of a px of the page.
  float canvas_px() const { return cells_per_px == 1 ? float(width_px) / float(bgra.cols) : 0.5f; }
};

/// The artwork as it fits into a box of canvas px. It is drawn at twice the canvas' resolution, and 8192 px large at
/// most. Errors as Drawers::render.
CanvasPage page_in_box(std::span<const std::uint8_t> bytes, const std::string& path, cv::Size box_px, Drawers& drawers,
                       Background background = Background::cut_out);

/// Regions are told by their colours, so that no colour may be taken for a background before.
Background background_of(const CanvasSpec& spec);

/// Of a canvas with a file and a size on paper: makes the box as large as the page within it, in mm exactly, in px as
/// `canvas`. Else does nothing. Errors as canvas_page.
void shrink_box_to_page(CanvasSpec& spec, const Canvas& canvas, Drawers& drawers);

/// The page of the spec's file, which touches the spec's box in width or height. Errors as load_canvas (canvas_file.h).
CanvasPage canvas_page(const CanvasSpec& spec, Drawers& drawers);

/// What was found for each pixel of the page (0 to 1), in the canvas' cells: the page's pixels where these are fine
/// enough, sizes rounded to even ones, else interpolated. As make_mask_canvas takes it.
Grid<float> coverage_on_canvas(const CanvasPage& page, const Grid<float>& coverage);

}  // namespace tessera
