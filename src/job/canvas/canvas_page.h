// The drawing of a canvas file, with the resolution that the canvas needs.
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

/// Reads the file of the key `key`. Throws InputError.
std::vector<std::uint8_t> read_canvas_file(const std::string& path, const char* key = "canvas.file");

struct CanvasPage {
  cv::Mat bgra;      // straight alpha
  int width_px = 0;  // of the canvas
  int height_px = 0;
  int cells_per_px = 2;  // resolution of coverage_on_canvas: 2 where the page can be drawn so fine, else 1

  /// Width of a page px in canvas px.
  float canvas_px() const { return cells_per_px == 1 ? float(width_px) / float(bgra.cols) : 0.5f; }
};

/// Draws the artwork fitted into a box in canvas px, at twice the canvas' resolution, but at most 8192 px large. Errors
/// as Drawers::render.
CanvasPage page_in_box(std::span<const std::uint8_t> bytes, const std::string& path, cv::Size box_px, Drawers& drawers,
                       Background background = Background::cut_out);

/// The treatment of the background by drawers. A canvas with regions keeps it: its colour may be that of a region.
Background background_of(const CanvasSpec& spec);

/// Reduces the box to the page within it, exactly in mm, and in px to the size of `canvas`. Does nothing unless the
/// canvas has a file and a size on paper. Errors as canvas_page.
void shrink_box_to_page(CanvasSpec& spec, const Canvas& canvas, Drawers& drawers);

/// The page of the spec's file; it touches the spec's box in width or height. Errors as load_canvas (canvas_file.h).
CanvasPage canvas_page(const CanvasSpec& spec, Drawers& drawers);

/// Converts a coverage (0 to 1) of the page's pixels to the canvas' cells, for make_mask_canvas. The pixels are taken
/// as they are where they are fine enough, with sizes rounded to even numbers; otherwise they are interpolated.
Grid<float> coverage_on_canvas(const CanvasPage& page, const Grid<float>& coverage);

}  // namespace tessera
