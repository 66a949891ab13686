// Relaxed pieces become ones that may stand: fields only estimate how deep they lie in each other, outlines decide.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placed_outlines.h"
#include "core/field/free_field.h"
#include "core/relax/relaxation.h"
#include "core/settings/settings.h"

namespace tessera {

/// Moves and shrinks those of `pieces` that `active` (indices) names and that are not fixed, and lets them grow again,
/// to 0.1 px more than they were, so that none of them conflicts (PlacedOutlines) with any other of `pieces` or with
/// the edge of the canvas of `free`, whatever lies in it. Scales and rotations stay within RelaxedPiece::poses. Returns
/// the indices, ascending, of active pieces that found no place: without them no active piece has a conflict. `check_stop` is
/// called now and then; where it throws, `pieces` are of no use any more.
std::vector<std::size_t> make_clear(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active,
                                    const FreeField& free, const PieceSettings& settings, const StopCheck& check_stop);

}  // namespace tessera
