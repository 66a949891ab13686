// Finds how a puzzle that was laid without its frame may lie in it as a whole.
#pragma once

#include <optional>
#include <vector>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

/// The poses frame_from_puzzle, the best first: turned so that the outer boundary lies along the frame. Pieces usually
/// reach the frame's edges, so no corner is needed; a round frame allows any turn.
std::vector<Similarity> poses_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                       const PuzzleScale& scale);

/// The pose frame_from_puzzle, with the scale at which the pieces reach the edges of the frame all around, even if some
/// pieces are missing. Empty: most of the frame's edge would stay open, or pieces would leave it.
std::optional<Similarity> scaled_pose_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                               const PuzzleScale& scale);

}  // namespace tessera
