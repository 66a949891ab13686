// Segments of curves, so that a descriptor of whole shapes can match parts of them: the naive extension of section 2 of
// the paper ("divide a shape into multiple instances of curve segments").
#pragma once

#include <vector>

#include "bench/descriptors/shape_descriptor.h"
#include "core/shape/model_sample.h"

namespace tessera::bench {

struct CurveSegment {
  /// Even points along it, both ends included, in the curve's own units: what docking aligns.
  Keypoints points{};
  float length = 0;  // the same units
  /// The area between the segment and its chord lies on its left, as that of a bulge does where the interior is on the
  /// left.
  bool bulges = false;
  Description description;
};

/// `line`: an open polyline without a curve_fault(). A segment that does not bulge is described the other way round, so
/// that the area on its left is positive: Hu's moments know no negative areas.
CurveSegment make_segment(std::vector<Vec2> line, const ShapeDescriptor& descriptor);

}  // namespace tessera::bench
