#include "core/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/quality/cell_counts.h"
#include "core/quality/gap_field.h"
#include "core/quality/nearest_copies.h"
#include "core/quality/piece_gaps.h"
#include "core/quality/shared_boundary.h"
#include "core/quality/style_spread.h"
#include "core/quality/variety.h"

namespace tessera {
namespace {

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
  quality.largest_gap_px = largest_gap_px(gap_field(counts, canvas.period));
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
