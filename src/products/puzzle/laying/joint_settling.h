// Settles all pieces of an arrangement at once.
#pragma once

#include <functional>
#include <vector>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

/// Moves the pieces so that all boundaries lie along those of their neighbours as well as possible: least squares of the
/// distances over all poses at once, in Gauss-Newton steps. Settling one piece after the other would need as many rounds as
/// there are pieces to remove a small error that runs through all of them. The first piece stays. `tell` is called before
/// each step; what it throws ends the work.
void settle_jointly(std::vector<PosedPiece>& pieces, const PuzzleScale& scale, int steps,
                    const std::function<void()>& tell);

}  // namespace tessera
