// Fills a puzzle's frame with straight-sided pieces that may be alike, as a tangram's: any way to cover it holds.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "products/puzzle/pieces/piece_matches.h"
#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

/// More pieces are not tried.
inline constexpr std::size_t kMostCoveringPieces = 24;

/// Poses frame_from_piece of all pieces but the last, which is the frame; nothing where none were found in a bounded
/// number of steps. A corner of what is free that is narrower than a straight line can only be filled by a corner of a
/// piece that lies along its side: the corner with the fewest such pieces comes first, each is tried, and where there
/// is none the last piece goes back. `watch` is called before each piece.
std::optional<std::vector<Similarity>> frame_covering(const std::vector<PuzzlePiece>& pieces,
                                                      const std::vector<std::vector<PieceMatch>>& matches,
                                                      const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
