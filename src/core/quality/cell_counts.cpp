#include "core/quality/cell_counts.h"

#include <algorithm>
#include <numeric>

#include "core/field/field_lookup.h"
#include "core/geometry/rasterise.h"

namespace tessera {
namespace {

constexpr std::size_t kMaxCells = std::size_t(1) << 26;  // 64 MiB a grid

int cells_per_px(const Canvas& canvas) {
  const std::size_t px = std::size_t(canvas.width_px) * canvas.height_px;
  return px * 16 <= kMaxCells ? 4 : px * 4 <= kMaxCells ? 2 : 1;
}

/// The cells of the canvas, with a rim outside the region, and of all pieces, up to half of the canvas' width and
/// height beyond it. So a piece far away takes no memory. On a seamless canvas: one period.
Window counted_cells(const Canvas& canvas, const std::vector<JudgedPiece>& pieces,
                     const Similarity& cells_from_canvas) {
  const int n = int(cells_from_canvas.a);
  const Window own{0, 0, canvas.width_px * n, canvas.height_px * n};
  Window all = own.grown(1);
  for (const JudgedPiece& piece : pieces) {
    for (const std::vector<Vec2>& curve : piece.outline_px.curves) {
      all = all.united(bounding_window({{curve}}, cells_from_canvas));
    }
  }
  all = all.intersected({-own.x1 / 2, -own.y1 / 2, own.x1 + own.x1 / 2, own.y1 + own.y1 / 2}).united(own.grown(1));
  const Window& columns = canvas.period.x_px > 0 ? own : all;
  const Window& rows = canvas.period.y_px > 0 ? own : all;
  return {columns.x0, rows.y0, columns.x1, rows.y1};
}

void count_piece(const Outline& piece_px, const Similarity& cells_from_canvas, CellCounts& counts) {
  for (const Span& span : fill_spans(piece_px, cells_from_canvas, counts.cells)) {
    std::uint8_t* covered = counts.covered.row(span.y - counts.cells.y0) - counts.cells.x0;
    const std::uint8_t* region = counts.region.row(span.y - counts.cells.y0) - counts.cells.x0;
    std::fill(covered + span.x0, covered + span.x1, std::uint8_t(1));
    counts.layers += std::accumulate(region + span.x0, region + span.x1, std::uint64_t(0));
  }
}

void mark_region(const Canvas& canvas, CellCounts& counts) {
  const FieldView edge(canvas.distance);
  const float cell_px = 1.f / float(counts.per_px);
  for (int y = 0; y < counts.region.height(); ++y) {
    const float y_px = (float(y + counts.cells.y0) + 0.5f) * cell_px;
    for (int x = 0; x < counts.region.width(); ++x) {
      counts.region(x, y) = field_value(edge, {(float(x + counts.cells.x0) + 0.5f) * cell_px, y_px}) > 0;
    }
  }
}

}  // namespace

CellCounts count_cells(const Canvas& canvas, const std::vector<JudgedPiece>& pieces) {
  CellCounts counts;
  counts.per_px = cells_per_px(canvas);
  const Similarity cells_from_canvas{float(counts.per_px), 0, 0, 0};
  counts.cells = counted_cells(canvas, pieces, cells_from_canvas);
  counts.covered = Grid<std::uint8_t>(counts.cells.width(), counts.cells.height(), 0);
  counts.region = Grid<std::uint8_t>(counts.cells.width(), counts.cells.height(), 0);
  mark_region(canvas, counts);
  for (const JudgedPiece& piece : pieces) {
    for (const Vec2 offset : canvas.period.offsets()) {
      count_piece(piece.outline_px, moved(cells_from_canvas, offset * float(counts.per_px)), counts);
    }
  }
  return counts;
}

}  // namespace tessera
