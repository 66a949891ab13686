#include "core/collage/standing_check.h"

#include <cstdint>

#include "core/field/field_lookup.h"
#include "core/geometry/rasterise.h"

namespace tessera {
namespace {

/// Tolerated fraction of a piece's area: a little more than a run leaves where pieces touch (kMaxOverlap).
constexpr double kShown = 0.06;

struct Cells {
  std::size_t inside = 0;  // the canvas, its zones included
  std::size_t kept_out = 0;
  std::size_t covered = 0;  // by earlier pieces
};

/// Counts the cells of the piece and its images, and marks them as covered.
Cells count_cells(const Canvas& canvas, const Outline& outline, const Similarity& canvas_from_shape,
                  Grid<std::uint8_t>& covered) {
  const FieldView free(canvas.distance);
  const FieldView zones(canvas.keep_out);
  Cells cells;
  for (const Vec2 offset : canvas.period.offsets()) {
    for (const Span& span : fill_spans(outline, moved(canvas_from_shape, offset), covered.bounds())) {
      for (int x = span.x0; x < span.x1; ++x) {
        const Vec2 middle_px{float(x) + 0.5f, float(span.y) + 0.5f};
        const bool kept_out = canvas.has_zones() && field_value(zones, middle_px) < 0;
        cells.kept_out += kept_out;
        cells.inside += kept_out || field_value(free, middle_px) > 0;
        cells.covered += covered(x, span.y);
        covered(x, span.y) = 1;
      }
    }
  }
  return cells;
}

}  // namespace

GivenPieceCheck check_given_pieces(const Canvas& canvas, const std::vector<GivenPiece>& pieces, float overlap_px,
                                   const std::function<const Shape&(ShapeId)>& shape) {
  Grid<std::uint8_t> covered(canvas.width_px, canvas.height_px, 0);
  GivenPieceCheck found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Similarity& pose = pieces[i].canvas_from_shape;
    const double scale_px = double(pose.scale());
    const double area_px2 = scale_px * scale_px;
    const Shape& placed = shape(pieces[i].shape);
    const double allowed_px2 = kShown * area_px2 + double(overlap_px * placed.perimeter) * scale_px / 2;
    const Cells cells = count_cells(canvas, placed.outline, pose, covered);
    if (double(cells.inside) < area_px2 - allowed_px2) found.outside.push_back(i);
    if (double(cells.kept_out) > allowed_px2) found.kept_out.push_back(i);
    if (double(cells.covered) > allowed_px2) found.overlapping.push_back(i);
  }
  return found;
}

}  // namespace tessera
