// Which pieces lie in the frame of their puzzle: nothing is laid beyond its edge.
#pragma once

#include <cstddef>

#include "products/puzzle/laying/arrangement.h"

namespace tessera {

/// About how many pieces of an arrangement without a frame lie in it, moved as a whole.
std::size_t pieces_within_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                                const PuzzleArranger& arranger);

/// The arrangement in the frame, which comes first in it, settled; without the pieces that lie beyond the frame's edge,
/// and without those that touch hardly anything then. Its places are not known.
Arrangement moved_into_frame(const Arrangement& alone, const Similarity& frame_from_puzzle,
                             const PuzzleArranger& arranger);

/// Of an arrangement in its frame: pieces that reach beyond the edge by more than the tolerance of outlines are moved
/// in, if they do so by little, and taken out otherwise.
void keep_within_frame(Arrangement& in, const PuzzleArranger& arranger);

}  // namespace tessera
