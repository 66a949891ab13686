// Traces a silhouette's coverage into smooth closed curves, or tells the reason why it makes no shape.
#pragma once

#include <variant>
#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/smoothing_spline.h"
#include "core/shape/shape.h"

namespace tessera {

/// Reasons why a drawing makes no shape. `hairlines`: thin lines make up much of the drawing. `hollow`: thin lines or
/// separate parts do, but the area they enclose would make a shape (TracingRules::fill_holes). `faint`: the visible
/// parts are too faint or too thin to count, and the rest makes no shape.
enum class SkipReason { empty, too_small, several_large_components, plain_rectangle, hairlines, hollow, faint };

/// The result of tracing. Artwork frame (px).
struct TracedOutline {
  std::vector<ClosedSpline> curves;  // the outer curve, then the holes; interior on the left
  int other_components = 0;          // number of components left out: specks beside the largest one
  float other_area_fraction = 0;     // area that they enclose / area that the largest one encloses
  float hollowness = 1;              // area that the outer curve encloses, as a multiple of its covered part
};

/// A pixel counts as covered from this opacity on; halos and shadows that fade out do not count.
inline constexpr float kEdgeOpacity = 0.5f;
/// Width of the smoothing (see smoothing_spline) in pixels of alpha or, if these are larger, of the source: enough to
/// remove the stairs.
inline constexpr float kSmoothing_px = 1;
inline constexpr float kSmoothing_sourcepx = 1.5f;
/// The least size (square root of the area) of a silhouette, in the same pixels.
inline constexpr float kLeastSize_px = 24;
/// Holes smaller than this fraction of the area that the outer curve encloses are filled.
inline constexpr float kLeastHole = 0.003f;
/// Other components above this fraction of the largest component's area belong to the picture.
inline constexpr float kLargestSpecks = 0.02f;
/// A silhouette that fills this fraction of its bounding box is a plain rectangle, which says nothing. A long box
/// counts as four times as long as wide, so that its length does not hide missing ends.
inline constexpr float kPlainRectangle = 0.97f;
/// Hairlines: opening by a disc of this radius (in square roots of the area) leaves less than kHairlineRest of the
/// area.
inline constexpr float kHairlineRadius = 0.035f;
inline constexpr float kHairlineRest = 0.7f;
/// A silhouette also counts as hairlines if its box is longer than this many square roots of its area: too thin for the
/// grid of its distance field.
inline constexpr float kLongest = 8;

/// An outline of at least this hollowness encloses much and covers little: other pieces find no place beside it, and it
/// leaves gaps.
inline constexpr float kHollow = 2;

/// The length of all curves.
float perimeter_of(const Outline& outline);

struct TracingRules {
  float edge_opacity = kEdgeOpacity;  // the outline runs where alpha has this value
  bool keep_rectangles = false;       // false: a plain rectangle is skipped, as it is mostly a drawing's background
  bool fill_holes = false;  // the area that the outer curve encloses belongs to the shape, with all parts in it
  bool opaque = false;  // only the drawing's edge is translucent: no pixel needs a look at how translucent parts end
};

/// Traces the outline of a drawing. `alpha`: coverage 0..1; node (i, j) is the pixel whose centre lies at origin_px +
/// (i + 0.5, j + 0.5). `source_px`: size of a source pixel in pixels of alpha: 0 for vectors, above 1 for an enlarged
/// image.
std::variant<TracedOutline, SkipReason> trace_outline(const Grid<float>& alpha, Vec2 origin_px, float source_px,
                                                      const TracingRules& rules = {});

}  // namespace tessera
