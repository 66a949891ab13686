// Terms of the objective (paper section 4: L, O_i, G_i), estimated along the piece's contour. kernels/docking_terms.cl
// computes the same for many at once, bit for bit.
#pragma once

#include "core/field/field_lookup.h"
#include "core/geometry/similarity.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_model.h"

namespace tessera {

struct DockingTerms {
  float matched_px = 0;         // L: boundary within delta_px of the free region's boundary
  float overlap_px2 = 0;        // sum of O_i
  float gap_px2 = 0;            // sum of G_i
  float overlap_px4 = 0;        // sum of O_i²
  float gap_px4 = 0;            // sum of G_i²
  float colour_difference = 0;  // CIEDE2000 to the place that the piece covers

  friend bool operator==(const DockingTerms&, const DockingTerms&) = default;
};

/// A gap is a run of boundary points whose distances lie between noise and gap_px; an overlap is a run below zero. The
/// area of a run is the sum of distance times boundary step. Covered interior points replace the overlap area where
/// they show more overlap.
DockingTerms docking_terms(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field,
                           const MatchingContext& context);

}  // namespace tessera
