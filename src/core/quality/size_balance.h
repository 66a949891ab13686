// Whether large and small pieces have an equal part in the picture. Sizes count by their logarithm: from 20 to 40 px is
// as far as from 80 to 160.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// Of pieces, as the square root of their area.
struct SizeRange {
  double min_px = 0;
  double max_px = 0;
};

/// From the smallest piece to the largest; 0 to 0 without pieces.
SizeRange size_range_of(const std::vector<JudgedPiece>& pieces);

/// Sizes below this are dwarfs: the lowest sixth of the range; 28 px of 20 to 160.
double dwarfs_below_px(const SizeRange& range);

struct SizeBalance {
  /// Entropy of the pieces' area over five equal parts of the range, by ln 5: 1 = each part has a fifth of the area,
  /// 0 = one has all of it.
  double evenness = 0;
  double dwarfs = 0;  // of the pieces' area, that of dwarfs
};

/// Sizes beyond the range count at its ends. Nothing where there are no pieces, where the range is less than 1 % wide:
/// then all sizes are one, and where its ends are no numbers, or too far apart to divide them.
std::optional<SizeBalance> size_balance(const std::vector<JudgedPiece>& pieces, const SizeRange& range);

}  // namespace tessera
