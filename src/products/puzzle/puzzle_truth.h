// How far a solution is from how the pieces were cut.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/similarity.h"

namespace tessera {

/// Poses puzzle_from_shape; a shape's frame has its centre as origin, and its size is the pose's scale.
struct PuzzleAgreement {
  int right = 0;          // pieces within kRightShift_px, kRightTurn_rad and kRightScale of the truth
  float worst_px = 0;     // of these
  int laid = 0;           // pieces that have a pose in both
  float farthest_px = 0;  // of these, from where it belongs
};

inline constexpr float kRightShift_px = 2;
inline constexpr float kRightTurn_rad = 0.017453293f;  // 1 degree
inline constexpr float kRightScale = 0.01f;            // part of the scale

/// A puzzle may be laid anywhere, turned and at any scale: the solution is moved as a whole so that one piece lies
/// where it lay, that one by which most are right. px: those of `truth`. Of pieces without a pose in either nothing
/// is said.
PuzzleAgreement agreement(const std::vector<std::optional<Similarity>>& found,
                          const std::vector<std::optional<Similarity>>& truth);

}  // namespace tessera
