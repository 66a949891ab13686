// Pieces of one outline, as those of a picture that was cut into equal rectangles: nothing but what is on them says which
// of them belongs where. Where several have been laid, the whole puzzle may agree better when two change places.
#pragma once

#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

struct ExchangedPieces {
  std::vector<Similarity> poses;  // puzzle_from_piece, of each piece that was given
  int undecided = 0;              // pieces that agree about as well in another place, or turned, or not where they lie
};

/// Exchanges two pieces of one outline, or turns one of them on its place, as long as the pictures on both sides of the
/// cuts agree better then. `laid`: all pieces, without the frame. Without pictures nothing moves, and nothing is said to
/// be undecided. `watch` is called often; what it throws ends it.
ExchangedPieces exchanged(const std::vector<PosedPiece>& laid, const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
