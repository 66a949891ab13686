// Where a puzzle that was laid without its frame may lie in it as a whole.
#pragma once

#include <optional>
#include <vector>

#include "core/puzzle/puzzle_contact.h"

namespace tessera {

/// frame_from_puzzle, the best first: turned so that the outer boundary lies along the frame. The pieces reach its edges
/// as a rule, so that no corner is needed; a round frame allows any turn.
std::vector<Similarity> poses_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                       const PuzzleScale& scale);

/// What was laid, where a piece of it fills a corner of the frame.
struct CornerPose {
  Similarity frame_from_puzzle;
  Vec2 corner;  // of the frame, where it stays at any scale
};

/// frame_from_puzzle with the scale at which the pieces reach the edges of the frame all round, also where some along the
/// edges are missing, or foreign ones lie beyond them. Nothing: too much of the frame's edge would stay open.
std::optional<Similarity> scaled_pose_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                               const std::vector<CornerPose>& corners, const PuzzleScale& scale);

}  // namespace tessera
