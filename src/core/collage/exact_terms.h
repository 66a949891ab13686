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
  float gap_px2 = 0;      // free, and no longer reachable for the smallest piece
};

/// The terms with these areas instead of the estimated ones. The division of an area into single gaps and overlaps
/// stays as estimated along the contour. If the estimate was 0, the area is one gap or overlap.
DockingTerms with_exact_areas(DockingTerms terms, const ExactAreas& areas);

/// Counts nodes in the piece's window. A gap node is one that a disc of reachable_radius_px could reach before the
/// piece is placed, and cannot reach afterwards.
ExactAreas exact_areas(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                       const OpenedField& opened, const PieceSettings& pieces);

/// The window of nodes from which exact_areas() counts.
Window exact_window(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                    const PieceSettings& pieces);

}  // namespace tessera
