// Turns relaxed pieces into pieces that may stand. Fields only estimate how deep pieces lie in each other; here the
// outlines decide.
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

/// Moves and shrinks pieces until they do not conflict (PlacedOutlines) with any other of `pieces` or with the canvas'
/// edge. It moves the pieces whose indices are in `active` and that are not fixed. Other content of the `free` field
/// does not count. Then the pieces grow again, up to 0.1 px more than before. Scales and rotations stay within
/// RelaxedPiece::poses. Returns the indices, ascending, of active pieces that found no place: without them no active
/// piece has a conflict. Calls `check_stop` regularly; if that throws, `pieces` are no longer usable.
std::vector<std::size_t> make_clear(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active,
                                    const FreeField& free, const PieceSettings& settings, const StopCheck& check_stop);

}  // namespace tessera
