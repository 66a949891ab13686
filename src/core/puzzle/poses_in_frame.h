// Where a puzzle that was laid without its frame may lie in it as a whole.
#pragma once

#include <vector>

#include "core/puzzle/puzzle_contact.h"

namespace tessera {

/// frame_from_puzzle, the best first: the centre of all pieces on the frame's, turned so that the outer boundary lies
/// along the frame. They fill it, so that no corner is needed; a round frame allows any turn.
std::vector<Similarity> poses_in_frame(const std::vector<PosedPiece>& laid, const PuzzlePiece& frame,
                                       const PuzzleScale& scale);

}  // namespace tessera
