// Segments of curves, with which a descriptor of whole shapes matches parts of shapes: the naive extension in section 2
// of the paper ("divide a shape into multiple instances of curve segments").
#pragma once

#include <vector>

#include "bench/descriptors/shape_descriptor.h"
#include "core/shape/model_sample.h"

namespace tessera::bench {

struct CurveSegment {
  /// Evenly spaced points along it, both ends included, in the curve's own units. Docking aligns them.
  Keypoints points{};
  float length = 0;  // in the same units
  /// Whether the area between the segment and its chord lies on its left. With the interior on the left that is so for
  /// a bulge.
  bool bulges = false;
  Description description;
};

/// Makes a segment. `line`: an open polyline without a curve_fault(). A segment that does not bulge is described in the
/// other direction, so that the area on its left is positive: Hu's moments do not allow negative areas.
CurveSegment make_segment(std::vector<Vec2> line, const ShapeDescriptor& descriptor);

}  // namespace tessera::bench
