// From a silhouette's coverage to smooth closed curves, or the reason why it is of no use.
#pragma once

#include <variant>
#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/smoothing_spline.h"
#include "core/shape/shape.h"

namespace tessera {

/// `hairlines`: thin lines make up much of the drawing. `hollow`: they do, or there are parts side by side, but what they
/// enclose would make a shape (TracingRules::fill_holes). `faint`: what is seen is too faint or too thin to count, and
/// the rest makes no shape.
enum class SkipReason { empty, too_small, several_large_components, plain_rectangle, hairlines, hollow, faint };

/// Artwork frame (px).
struct TracedOutline {
  std::vector<ClosedSpline> curves;  // the outer one, then the holes; interior on the left
  int other_components = 0;          // left out: specks beside the largest component
  float other_area_fraction = 0;     // what they enclose, in parts of what the largest one encloses
  float hollowness = 1;              // what the outer curve encloses, in parts of what is covered of it
};

/// What a drawing covers by half is in; halos and shadows that fade out are not.
inline constexpr float kEdgeOpacity = 0.5f;
/// Width of the smoothing (see smoothing_spline) in pixels of alpha or, where these are larger, of the source: as
/// much as takes the stairs out.
inline constexpr float kSmoothing_px = 1;
inline constexpr float kSmoothing_sourcepx = 1.5f;
/// A silhouette must have this size (square root of its area), in the same pixels, to have a shape at all.
inline constexpr float kLeastSize_px = 24;
/// Holes smaller than this part of the area that the outer curve encloses are filled.
inline constexpr float kLeastHole = 0.003f;
/// Above this part of the largest component's area the others belong to the picture.
inline constexpr float kLargestSpecks = 0.02f;
/// A silhouette that fills so much of its box is a plain rectangle, which says nothing. Of a long box, ends of twice its
/// width count.
inline constexpr float kPlainRectangle = 0.97f;
/// Hairlines: an opening by a disc of this radius (in square roots of the area) leaves less than that part of the area.
inline constexpr float kHairlineRadius = 0.035f;
inline constexpr float kHairlineRest = 0.7f;
/// Or its box is longer than so many square roots of the area: too thin for the grid of its distance field.
inline constexpr float kLongest = 8;

/// Such an outline encloses much and covers little: others find no place beside it, and it leaves gaps.
inline constexpr float kHollow = 2;

/// Length of all curves.
float perimeter_of(const Outline& outline);

struct TracingRules {
  float edge_opacity = kEdgeOpacity;  // the outline runs where alpha is this
  bool keep_rectangles = false;       // a plain rectangle is a drawing's background, as a rule, and skipped
  bool fill_holes = false;            // what the outer curve encloses belongs to the shape, parts that lie in it too
};

/// `alpha`: coverage 0..1; node (i, j) is the pixel whose centre lies at origin_px + (i + 0.5, j + 0.5). `source_px`:
/// size of a pixel of the source in pixels of alpha: 0 for vectors, above 1 for an enlarged image.
std::variant<TracedOutline, SkipReason> trace_outline(const Grid<float>& alpha, Vec2 origin_px, float source_px,
                                                      const TracingRules& rules = {});

}  // namespace tessera
