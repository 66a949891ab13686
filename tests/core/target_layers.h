// The three layers of the target on canvases with edges and without. Layers updated placement by placement, or for all together, equal layers made afresh.
#pragma once

#include <rapidcheck.h>

#include <utility>
#include <vector>

#include "core/field/target_curve.h"
#include "core/random_pieces.h"

namespace tessera::test {

struct Target {
  FreeField free;
  OpenedField opened;
  TargetCurve curve;

  Target(FreeField field, const PieceSettings& pieces)
      : free(std::move(field)),
        opened(free, pieces),
        curve(pieces, PadParameters{}) {
    trace(free.grid().nodes());
  }
  Target(const Canvas& canvas, const PieceSettings& pieces) : Target(FreeField(canvas, pieces), pieces) {}

  TargetCurve::Change trace(const Window& window) { return curve.retrace(opened, free.field().origin, {window}); }
  TargetCurve::Change place(const Piece& piece) { return place_all({piece}); }
  /// Traces the curve once for all of them.
  TargetCurve::Change place_all(const std::vector<Piece>& pieces) {
    std::vector<Window> stamped;
    for (const Piece& piece : pieces) stamped.push_back(free.stamp(four_shapes()[piece.shape], piece.pose));
    return curve.retrace(opened, free.field().origin, opened.update(free, stamped));
  }
};

/// Expects equality to the bit. Call it within a property of RapidCheck.
inline void expect_updating_equals_tracing_afresh(const Canvas& canvas, const PieceSettings& settings,
                                                  const std::vector<Piece>& pieces) {
  Target updated(canvas, settings);
  FreeField free(canvas, settings);
  for (const Piece& piece : pieces) {
    updated.place(piece);
    free.stamp(four_shapes()[piece.shape], piece.pose);
  }
  Target together(canvas, settings);
  together.place_all(pieces);
  RC_ASSERT(together.curve.samples() == updated.curve.samples());
  const Target afresh(std::move(free), settings);
  RC_ASSERT(updated.free.field().value.data() == afresh.free.field().value.data());
  RC_ASSERT(updated.opened.contour().data() == afresh.opened.contour().data());
  RC_ASSERT(updated.curve.samples() == afresh.curve.samples());
  for (const SampleId id : afresh.curve.samples()) {
    RC_ASSERT(together.curve.sample(id).pyramid == afresh.curve.sample(id).pyramid);
    RC_ASSERT(updated.curve.sample(id).pyramid == afresh.curve.sample(id).pyramid);
    RC_ASSERT(updated.curve.sample(id).position == afresh.curve.sample(id).position);
    RC_ASSERT(updated.curve.sample(id).tangent == afresh.curve.sample(id).tangent);
  }
}

}  // namespace tessera::test
