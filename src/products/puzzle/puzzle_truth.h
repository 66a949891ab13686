// Compares a solution with the way in which the pieces were cut.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/similarity.h"

namespace tessera {

/// Both lists hold poses puzzle_from_shape. A shape's frame has its centre as origin, and its size is the pose's scale.
struct PuzzleAgreement {
  int right = 0;          // pieces within kRightShift_px, kRightTurn_rad and kRightScale of the truth
  float worst_px = 0;     // largest distance of these
  int laid = 0;           // pieces that have a pose in both lists
  float farthest_px = 0;  // largest distance of these from where they belong
};

inline constexpr float kRightShift_px = 2;
inline constexpr float kRightTurn_rad = 0.017453293f;  // 1 degree
inline constexpr float kRightScale = 0.01f;            // part of the scale

/// A puzzle may be laid anywhere, turned and at any scale. So the solution is moved as a whole until one piece lies where
/// it was cut; the piece that makes most pieces right is chosen. px: those of `truth`. Pieces without a pose in one of the
/// lists do not count.
PuzzleAgreement agreement(const std::vector<std::optional<Similarity>>& found,
                          const std::vector<std::optional<Similarity>>& truth);

}  // namespace tessera
