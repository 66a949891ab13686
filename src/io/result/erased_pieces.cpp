#include "io/result/erased_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/error.h"
#include "core/geometry/rasterise.h"
#include "io/job/canvas_file.h"
#include "io/job/canvas_page.h"

namespace tessera::io {
namespace {

constexpr double kTouched_px2 = 4;

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

/// Sizes in px are rounded, a small picture's most of all.
void check_aspect(const CanvasPage& page, const std::string& where, const Canvas& canvas) {
  constexpr float kRounded = 0.01f;
  const auto near = [](int fitted_px, int side_px) {
    return float(std::abs(fitted_px - side_px)) <= 1 + kRounded * float(side_px);
  };
  if (near(page.width_px, canvas.width_px) && near(page.height_px, canvas.height_px)) return;
  throw InputError(where + ": found another aspect: fitted into the canvas it has " +
                   size_text(page.width_px, page.height_px) +
                   " px, needed: " + size_text(canvas.width_px, canvas.height_px) + ", as collage.png has it");
}

double marked_px2(const Grid<float>& mask, const Outline& outline_px, Vec2 offset, float cells_per_px) {
  std::size_t cells = 0;
  const Similarity cells_from_canvas = scaled({1, 0, offset.x, offset.y}, cells_per_px);
  for (const Span& span : fill_spans(outline_px, cells_from_canvas, mask.bounds())) {
    const float* row = mask.row(span.y);
    cells += std::size_t(std::count_if(row + span.x0, row + span.x1, [](float part) { return part >= 0.5f; }));
  }
  return double(cells) / (double(cells_per_px) * double(cells_per_px));
}

}  // namespace

std::vector<int> pieces_in(const Box& box, const std::vector<PlacedPiece>& pieces) {
  std::vector<int> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec2 at = pieces[i].canvas_from_shape.translation();
    if (at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y) found.push_back(int(i));
  }
  return found;
}

Grid<float> erasing_mask(const std::string& file, const std::string& option, const Canvas& canvas) {
  const std::string where = option + " " + file;
  const CanvasSpec spec{.width_px = canvas.width_px, .height_px = canvas.height_px, .file = file};
  Drawers drawers(canvas_drawer_settings(spec));
  const std::vector<std::uint8_t> bytes = read_canvas_file(file, option.c_str());
  const CanvasPage page = page_in_box(bytes, file, {canvas.width_px, canvas.height_px}, drawers);
  check_aspect(page, where, canvas);
  Grid<float> mask = coverage_on_canvas(page, mask_coverage(page.bgra));
  const std::vector<float>& cells = mask.data();
  if (std::none_of(cells.begin(), cells.end(), [](float part) { return part >= 0.5f; })) {
    throw InputError(where +
                     ": shows nothing; needed: what is drawn over the pieces that are to go, on a transparent " +
                     "page or a plain background");
  }
  return mask;
}

std::vector<int> pieces_under(const Grid<float>& mask, const std::vector<JudgedPiece>& pieces, const Canvas& canvas) {
  const float cells_per_px = std::round(float(mask.width()) / float(canvas.width_px));
  std::vector<int> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double touched_px2 = 0;
    for (const Vec2 offset : canvas.period.offsets()) {
      touched_px2 += marked_px2(mask, pieces[i].outline_px, offset, cells_per_px);
    }
    const double enough_px2 = std::min(kTouched_px2, 0.9 * pieces[i].scale_px * pieces[i].scale_px);
    if (touched_px2 >= enough_px2) found.push_back(int(i));
  }
  return found;
}

}  // namespace tessera::io
