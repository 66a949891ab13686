// The collage's target curve, traced from a free field as in the engine, and stretches of it.
#pragma once

#include <optional>
#include <vector>

#include "core/field/canvas.h"
#include "core/field/linked_contour.h"
#include "core/field/target_sample.h"
#include "core/settings/settings.h"

namespace tessera::bench {

class TargetStretches {
 public:
  /// The canvas must not repeat.
  explicit TargetStretches(const PieceSettings& pieces);

  /// Traces the whole curve again. `free`: the free field at the canvas' nodes, with paddings subtracted.
  void trace(const CanvasField& free);

  /// The smoothed target curve from the sample's left end of `level` to its right end, canvas px, with the free region
  /// on the left. Empty where the sample is not on the curve, or where the stretch would be the whole closed curve.
  std::vector<Vec2> around(const TargetSample& sample, int level);

 private:
  std::optional<std::vector<int>> walk(int from, float length_px, bool forward, int last);

  PieceSettings pieces_;
  std::optional<LinkedContour> curve_;
};

}  // namespace tessera::bench
