// The quality of a finished collage, measured on the exact outlines, independent of the fields that built it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/quality/judged_piece.h"
#include "core/quality/size_balance.h"
#include "core/shape/shape.h"

namespace tessera {

/// Pieces nearer than this share their boundary and are not alone.
inline constexpr float kSharedWithin_px = 2;

struct Quality {
  double coverage = 0;         // covered area / canvas area
  double overlap = 0;          // sum over the canvas of (covering pieces - 1), / canvas area
  double outside = 0;          // covered area outside the canvas (up to half a canvas beyond each side) / canvas area
  double shared_boundary = 0;  // fraction of the pieces' boundary within 2 px of another's or of the canvas' edge
  std::size_t pieces = 0;
  std::size_t distinct_shapes = 0;             // 0 although there are pieces: their shapes are unknown
  std::optional<double> effective_shapes;      // variety.h
  std::array<double, 5> scale_px_quantiles{};  // minimum, 10 %, median, 90 %, maximum
  double largest_gap_px = 0;                   // radius of the largest disc that still fits into the free region
  SizeRange size_range_px;                     // range of sizes that balance is measured in
  std::optional<SizeBalance> balance;          // size_balance.h
  std::optional<double> copies_px;             // nearest_copies.h: median distance of a piece's nearest copy
  std::optional<double> copies_apart;          // copies_px / the canvas' diagonal
  std::optional<double> between_px;            // piece_gaps.h: the smallest gap between two pieces
  std::optional<double> style_distance;        // style_spread.h: mean distance of two pieces
  double alone = 0;                            // fraction of the pieces without another within kSharedWithin_px
};

/// Measures a collage. Areas are counted on cells of a quarter px (half or a whole px on canvases above 4 and 16 Mpx);
/// the boundary is sampled every half px. On a seamless canvas all figures are of one period, and gaps are measured up
/// to half a period on each side of it. `sizes`: the possible sizes of pieces; empty: from the smallest to the largest
/// piece.
Quality measure_quality(const Canvas& canvas, const std::vector<JudgedPiece>& pieces,
                        const std::optional<SizeRange>& sizes = {});

/// Measures a collage given by placements. `shape(i)` gives library shape i with its outline.
Quality measure_quality(const Canvas& canvas, const std::vector<Placement>& placements,
                        const std::function<const Shape&(ShapeId)>& shape, const std::optional<SizeRange>& sizes = {});

}  // namespace tessera
