// Measures whether large and small pieces have equal parts of the picture. Sizes count by their logarithm: 20 to 40 px
// is the same distance as 80 to 160.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// A range of sizes of pieces, as the square root of their area.
struct SizeRange {
  double min_px = 0;
  double max_px = 0;
};

/// The range from the smallest piece to the largest; 0 to 0 without pieces.
SizeRange size_range_of(const std::vector<JudgedPiece>& pieces);

/// Pieces below this size are dwarfs: the lowest sixth of the range; 28 px for 20 to 160.
double dwarfs_below_px(const SizeRange& range);

struct SizeBalance {
  /// Entropy of the pieces' area over five equal parts of the range, divided by ln 5. 1: each part has a fifth of the
  /// area; 0: one part has all of it.
  double evenness = 0;
  double dwarfs = 0;  // fraction of the pieces' area that belongs to dwarfs
};

/// The balance of the pieces. Sizes beyond the range count at its ends. Empty if there are no pieces or if the range is
/// narrower than 1 %, so that all sizes are equal. Also empty if the ends of the range are not finite numbers that can
/// be divided.
std::optional<SizeBalance> size_balance(const std::vector<JudgedPiece>& pieces, const SizeRange& range);

}  // namespace tessera
