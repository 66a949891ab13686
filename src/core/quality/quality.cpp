#include "core/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "core/field/field_lookup.h"
#include "core/geometry/distance_transform.h"
#include "core/geometry/periodic_grid.h"
#include "core/geometry/rasterise.h"
#include "core/quality/nearest_copies.h"
#include "core/quality/piece_gaps.h"
#include "core/quality/shared_boundary.h"
#include "core/quality/style_spread.h"
#include "core/quality/variety.h"

namespace tessera {
namespace {

constexpr std::size_t kMaxCells = std::size_t(1) << 26;     // 64 MiB a grid
constexpr std::size_t kMaxGapNodes = std::size_t(1) << 23;  // two float grids of 32 MiB
constexpr int kMaxGapSides = 32768;  // largest sum of width and height for the distance transform

/// Cells of the canvas: which are covered by pieces, and which belong to the region to fill; 0 or 1.
struct CellCounts {
  int per_px = 1;
  Window cells;  // node (0, 0) of the grids is the upper left cell
  Grid<std::uint8_t> covered;
  Grid<std::uint8_t> region;
  std::uint64_t layers = 0;  // sum, over the cells of the region, of the number of pieces that cover the cell
};

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

void measure_areas(const CellCounts& counts, double canvas_area_px2, Quality& quality) {
  std::uint64_t covered = 0;
  std::uint64_t outside = 0;
  for (std::size_t i = 0; i < counts.covered.data().size(); ++i) {
    (counts.region.data()[i] ? covered : outside) += counts.covered.data()[i];
  }
  const double cells = canvas_area_px2 * counts.per_px * counts.per_px;
  quality.coverage = double(covered) / cells;
  quality.overlap = double(counts.layers - covered) / cells;
  quality.outside = double(outside) / cells;
}

/// The cells in which gaps are searched.
Window gap_cells(const CellCounts& counts, const Period& period) {
  const int beyond_x = period.x_px * counts.per_px / 2;
  const int beyond_y = period.y_px * counts.per_px / 2;
  return {-beyond_x, -beyond_y, counts.cells.width() + beyond_x, counts.cells.height() + beyond_y};
}

/// Gaps are searched on every `step`-th cell in both directions. That is fine enough for a distance, and there are 4 to
/// 16 times fewer cells to transform.
int gap_step(const Window& cells, int per_px) {
  int step = std::max(1, per_px / 2);
  while (cells.width() / step * std::size_t(cells.height() / step) > kMaxGapNodes ||
         (cells.width() + cells.height()) / step + 2 > kMaxGapSides) {
    ++step;
  }
  return step;
}

double largest_gap_px(const CellCounts& counts, const Period& period) {
  const Window cells = gap_cells(counts, period);
  const int step = gap_step(cells, counts.per_px);
  const PeriodicGrid images(counts.region.bounds(), counts.region.bounds(),
                            {period.x_px * counts.per_px, period.y_px * counts.per_px});
  // A rim of nodes that are never free: the rim of one cell may lie between the nodes.
  Grid<std::uint8_t> taken(cells.width() / step + 2, cells.height() / step + 2, 1);
  bool any_free = false;
  for (int y = 1; y + 1 < taken.height(); ++y) {
    const int row = images.row(cells.y0 + (y - 1) * step);
    for (int x = 1; x + 1 < taken.width(); ++x) {
      const int column = images.column(cells.x0 + (x - 1) * step);
      const bool free = counts.region(column, row) && !counts.covered(column, row);
      taken(x, y) = !free;
      any_free |= free;
    }
  }
  if (!any_free) return 0;
  const Grid<float> squared = squared_distance_to(taken);
  const double nodes = std::sqrt(double(*std::max_element(squared.data().begin(), squared.data().end())));
  // The edge runs, on average, midway between the last free node and the first taken one.
  return (nodes - 0.5) * step / counts.per_px;
}

/// Linear interpolation between the sorted values.
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * double(sorted.size() - 1);
  const std::size_t below = std::size_t(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (sorted[above] - sorted[below]) * (at - double(below));
}

std::array<double, 5> scale_quantiles(const std::vector<JudgedPiece>& pieces) {
  if (pieces.empty()) return {};
  std::vector<double> scales;
  for (const JudgedPiece& piece : pieces) scales.push_back(piece.scale_px);
  std::sort(scales.begin(), scales.end());
  return {scales.front(), quantile(scales, 0.1), quantile(scales, 0.5), quantile(scales, 0.9), scales.back()};
}

std::size_t count_distinct_shapes(const std::vector<JudgedPiece>& pieces) {
  std::set<std::string> names;
  for (const JudgedPiece& piece : pieces) {
    if (!piece.shape.empty()) names.insert(piece.shape);
  }
  return names.size();
}

void measure_sizes(const std::vector<JudgedPiece>& pieces, const std::optional<SizeRange>& sizes, Quality& quality) {
  quality.scale_px_quantiles = scale_quantiles(pieces);
  quality.size_range_px = sizes ? *sizes : size_range_of(pieces);
  quality.balance = size_balance(pieces, quality.size_range_px);
}

void measure_copies(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, Quality& quality) {
  quality.distinct_shapes = count_distinct_shapes(pieces);
  quality.effective_shapes = effective_shapes(pieces);
  quality.style_distance = mean_style_distance(pieces);
  quality.copies_px = median_copy_distance_px(pieces, canvas.period);
  if (quality.copies_px) quality.copies_apart = *quality.copies_px / std::hypot(canvas.width_px, canvas.height_px);
}

void measure_contact(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, Quality& quality) {
  quality.shared_boundary = shared_boundary_fraction(canvas, pieces, kSharedWithin_px);
  const PieceGaps gaps = piece_gaps(pieces, canvas.period, kSharedWithin_px);
  quality.between_px = gaps.smallest_px;
  quality.alone = gaps.alone;
}

}  // namespace

Quality measure_quality(const Canvas& canvas, const std::vector<JudgedPiece>& pieces,
                        const std::optional<SizeRange>& sizes) {
  Quality quality;
  quality.pieces = pieces.size();
  const CellCounts counts = count_cells(canvas, pieces);
  measure_areas(counts, canvas.area_px2, quality);
  quality.largest_gap_px = largest_gap_px(counts, canvas.period);
  measure_sizes(pieces, sizes, quality);
  measure_copies(canvas, pieces, quality);
  measure_contact(canvas, pieces, quality);
  return quality;
}

Quality measure_quality(const Canvas& canvas, const std::vector<Placement>& placements,
                        const std::function<const Shape&(ShapeId)>& shape, const std::optional<SizeRange>& sizes) {
  return measure_quality(canvas, judged_pieces(placements, shape), sizes);
}

}  // namespace tessera
