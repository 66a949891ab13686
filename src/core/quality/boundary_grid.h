// Samples of the boundaries of all pieces, and a search for those of other pieces near a place.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "core/quality/judged_piece.h"

namespace tessera {

struct EdgeSample {
  Vec2 position_px;
  std::uint32_t piece;
  bool image = false;  // an image across a seam: near to other pieces, but not part of the counted boundary
};

/// Samples of the boundaries every half px, in the order of the pieces, moved into the first period; with the images
/// across a seam within `reach_px` of it. A distance of 2 px between samples has an error of at most 0.016 px.
std::vector<EdgeSample> edge_samples(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px);

/// Samples sorted into square buckets at least as wide as the reach, so that a query tests nine of them. In each bucket
/// they are in the order of the pieces, so that a query skips its own piece at once.
class BoundaryGrid {
 public:
  /// `samples`: at least one, in the order of the pieces.
  BoundaryGrid(const std::vector<EdgeSample>& samples, float reach_px);

  /// Whether a sample of another piece lies within reach of the sample.
  bool another_piece_near(const EdgeSample& sample) const;

  /// The distance from a place on the boundary of `piece` to the nearest sample of another piece; `reach_px` where there is
  /// none within it.
  float distance_to_another_px(Vec2 position_px, std::uint32_t piece) const;

 private:
  int column_of(Vec2 p) const;
  int row_of(Vec2 p) const;
  std::size_t bucket_of(Vec2 p) const { return std::size_t(row_of(p)) * first_.width() + column_of(p); }

  /// Calls f(sample) for the samples of other pieces in the bucket until one call returns true; returns whether one did.
  template <class F>
  bool any_of_others(std::size_t bucket, std::uint32_t piece, F f) const;

  float reach_px_;
  float bucket_px_ = 0;
  Vec2 low_px_;                // of the first bucket
  Grid<std::uint32_t> first_;  // first index of a bucket's samples in sorted_
  std::vector<EdgeSample> sorted_;
};

}  // namespace tessera
