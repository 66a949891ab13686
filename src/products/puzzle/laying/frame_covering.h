// Fills a puzzle's frame with straight-sided pieces that may be alike, as in a tangram: any way to cover the frame is
// right.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "products/puzzle/pieces/piece_matches.h"
#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

/// It tries at most so many pieces.
inline constexpr std::size_t kMostCoveringPieces = 24;

/// The poses frame_from_piece of all pieces but the last, which is the frame; empty where a bounded number of steps finds
/// none. A corner of the free area that is narrower than a straight line can only be filled by a piece's corner along its
/// side. The corner with the fewest such pieces comes first, each of them is tried, and where there is none the last piece
/// is taken back. `check_stop` is called before each piece.
std::optional<std::vector<Similarity>> frame_covering(const std::vector<PuzzlePiece>& pieces,
                                                      const std::vector<std::vector<PieceMatch>>& matches,
                                                      const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
