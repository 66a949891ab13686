#include "package/known_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/closed_curve.h"
#include "core/shape/outline.h"
#include "core/shape/shape_builder.h"
#include "package/number_in_message.h"
#include "package/prepared_curves.h"
#include "recognition/library_lots.h"
#include "tessera/matching/error.h"

namespace tessera::matching {
namespace {

/// Limits of a shape, in square roots of its area: its outline has 512 points, its distance field 128 x 128 nodes.
constexpr double kLongestBox = kLongest;
constexpr double kLongestBoundary = 100;

/// The outer curve, then the holes within it.
tessera::Outline outer_and_holes(const std::vector<tessera::Curve>& curves) {
  const tessera::Curve* outer = nullptr;
  double largest = 0;
  for (const tessera::Curve& curve : curves) {
    if (!curve.closed || signed_area(curve.points) <= largest) continue;
    outer = &curve;
    largest = signed_area(curve.points);
  }
  if (!outer) {
    throw Error(
        "found no closed curve with its interior on the left, allowed: an outer boundary, as of make_outline()");
  }
  tessera::Outline outline{{outer->points}};
  for (const tessera::Curve& curve : curves) {
    if (curve.closed && signed_area(curve.points) < 0 && contains(outer->points, curve.points.front())) {
      outline.curves.push_back(curve.points);
    }
  }
  return outline;
}

void check_compact(const tessera::Outline& outline) {
  const double area = area_moment(outline).area;
  if (!(area > 0)) throw Error("found holes as large as the outer curve or larger, allowed: smaller ones");
  const double unit = std::sqrt(area);
  const Box box = bounding_box(outline);
  const double extent = std::max(box.width(), box.height());
  if (extent > kLongestBox * unit) {
    throw Error("too thin: it is " + number_in_message(extent / unit) +
                " times as long as the square root of its area; allowed: 8 times");
  }
  if (perimeter_of(outline) > kLongestBoundary * unit) {
    throw Error("its boundary is " + number_in_message(double(perimeter_of(outline)) / unit) +
                " times as long as the square root of its area; allowed: 100 times");
  }
}

TracedOutline traced(const tessera::Outline& outline, double sigma) {
  TracedOutline result;
  for (const std::vector<Vec2>& curve : outline.curves) {
    // of small holes; wider smoothing would leave nothing of them
    const double widest = double(closed_length(curve)) / 24;
    result.curves.push_back(smoothing_spline(curve, std::min(std::max<double>(sigma, kSmoothing_px), widest)));
  }
  return result;
}

}  // namespace

KnownShape make_known_shape(const Outline& outline) {
  const PreparedCurves prepared = prepared_curves(outline);
  const tessera::Outline kept = outer_and_holes(prepared.curves);
  check_compact(kept);
  const Shape shape = make_shape(traced(kept, prepared.least_sigma), {});
  const Similarity prepared_from_shape{shape.artwork.unit_px, 0, shape.artwork.centroid_px.x,
                                       shape.artwork.centroid_px.y};
  return {make_shape_model(shape, {}, {}, kSearchedLevels), shape.outline,
          (prepared.own_from_prepared * prepared_from_shape).inverse()};
}

}  // namespace tessera::matching
