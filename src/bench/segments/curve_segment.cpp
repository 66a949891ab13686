#include "bench/segments/curve_segment.h"

#include <algorithm>
#include <utility>

#include "core/geometry/polygon.h"

namespace tessera::bench {

CurveSegment make_segment(std::vector<Vec2> line, const ShapeDescriptor& descriptor) {
  Curve curve{std::move(line), false};
  CurveSegment segment;
  segment.length = length_of(curve);
  segment.bulges = signed_area(curve.points) > 0;
  const Curve even = resampled(curve, int(segment.points.size()));
  std::copy(even.points.begin(), even.points.end(), segment.points.begin());
  if (!segment.bulges) std::reverse(curve.points.begin(), curve.points.end());
  segment.description = descriptor.describe({curve}, 0);
  return segment;
}

}  // namespace tessera::bench
