// Keeps pieces within the frame of their puzzle.
#pragma once

#include <cstddef>

#include "products/puzzle/laying/arrangement.h"

namespace tessera {

/// About how many pieces of an arrangement without a frame lie in the frame, when it is moved as a whole.
std::size_t pieces_within_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                                const PuzzleArranger& arranger);

/// The arrangement moved into the frame, which becomes its first piece, and settled. Pieces beyond the frame's edge are
/// left out, and pieces that then hardly touch others. Its places are not known.
Arrangement moved_into_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                             const PuzzleArranger& arranger);

/// Handles pieces of an arrangement in its frame that reach beyond the edge by more than the outlines' tolerance: it moves
/// them in if it is little, and takes them out otherwise.
void keep_within_frame(Arrangement& in, const PuzzleArranger& arranger);

}  // namespace tessera
