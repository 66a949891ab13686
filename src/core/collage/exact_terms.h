// The exact areas of the objective's terms, for the finalists of a round.
#pragma once

#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/geometry/similarity.h"
#include "core/matching/docking_terms.h"
#include "core/settings/settings.h"
#include "core/shape/shape.h"

namespace tessera {

struct ExactAreas {
  float overlap_px2 = 0;  // covered twice, or outside the canvas
  float gap_px2 = 0;      // free, and out of reach of the smallest piece from now on
};

/// The terms with these areas in the place of the estimated ones. How an area is divided into single gaps and overlaps
/// stays as estimated along the contour; where that saw none, it is one.
DockingTerms with_exact_areas(DockingTerms terms, const ExactAreas& areas);

/// Counts nodes in the piece's window. A gap node could be reached by a disc of reachable_radius_px before the piece
/// is placed, and cannot afterwards.
ExactAreas exact_areas(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                       const OpenedField& opened, const PieceSettings& pieces);

/// The window of nodes from which exact_areas() counts.
Window exact_window(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                    const PieceSettings& pieces);

}  // namespace tessera
