// Exchanges pieces with the same outline, for example of a picture that was cut into equal rectangles. Only their pictures
// tell where they belong, so the whole puzzle may agree better when two pieces change places.
#pragma once

#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

struct ExchangedPieces {
  std::vector<Similarity> poses;  // puzzle_from_piece, of each given piece
  int undecided = 0;              // pieces that agree about as well in another place or turn, or not where they lie
};

/// Exchanges two pieces of one outline, or turns one in its place, as long as the pictures on both sides of the cuts then
/// agree better. `laid`: all pieces, without the frame. Without pictures nothing moves, and no piece counts as undecided.
/// `check_stop` is called often; what it throws ends the work.
ExchangedPieces exchanged(const std::vector<PosedPiece>& laid, const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
