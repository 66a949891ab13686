// A layout without a search: pieces in columns beside each other, by their boxes. It is what there is of a layout before
// a search has found a better one.
#pragma once

#include <vector>

#include "core/nesting/nest_problem.h"
#include "core/nesting/posed_shape.h"

namespace tessera {

/// Adds pieces, given by their items, to the layout: on a strip from x = `from` on, on sheets from a new sheet on. Each
/// item must fit at one of its angles. `layout.used_length` then is that of the strip, or of the last sheet.
void add_in_columns(const NestProblem& problem, const PosedItems& shapes, const std::vector<int>& items, double from,
                    NestLayout& layout);

}  // namespace tessera
