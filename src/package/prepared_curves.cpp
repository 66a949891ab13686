#include "package/prepared_curves.h"

#include <algorithm>
#include <string>

#include "package/outline_box.h"

namespace tessera::matching {

PreparedCurves prepared_curves(const Outline& outline) {
  check(outline);
  const OutlineBox box = box_of(outline);
  PreparedCurves result;
  result.own_from_prepared = {box.extent() / kPreparedExtent, 0, box.middle().x, box.middle().y};
  const Similarity prepared_from_own = result.own_from_prepared.inverse();
  for (const Curve& curve : outline.curves) {
    tessera::Curve& prepared = result.curves.emplace_back();
    prepared.closed = curve.closed;
    prepared.points.reserve(curve.points.size());
    for (const Point own : curve.points) {
      const Point p = prepared_from_own.apply(own);
      prepared.points.push_back({float(p.x), float(p.y)});
    }
    // Points that differ as doubles may be equal as floats.
    const std::string fault = curve_fault(prepared);
    if (!fault.empty()) throw Error("curve " + std::to_string(result.curves.size() - 1) + ": " + fault);
  }
  const double sigma = outline.smoothing > 0 ? result.prepared(outline.smoothing) : kDefaultSigma;
  result.least_sigma = float(std::max(sigma, kLeastSigma));
  return result;
}

}  // namespace tessera::matching
