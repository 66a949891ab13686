// All pieces of an arrangement come to rest at once.
#pragma once

#include <functional>
#include <vector>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

/// Moves the pieces so that all boundaries lie along those of their neighbours as well as they can: least squares of the
/// distances over all poses at once, steps of Gauss and Newton. One piece after the other would take as many rounds as there
/// are pieces until a small error that runs through all of them is gone. The first piece stays. `tell` is called before each
/// step; what it throws ends the work.
void settle_jointly(std::vector<PosedPiece>& pieces, const PuzzleScale& scale, int steps,
                    const std::function<void()>& tell);

}  // namespace tessera
