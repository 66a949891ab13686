// A piece's shape turned by one of its angles, ready to be held against others.
#pragma once

#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_poles.h"
#include "products/nesting/layout/nest_problem.h"

namespace tessera {

struct PosedShape {
  NestRing boundary;  // of the search outline, the first point again at its end
  NestRing body;      // what it is grown from
  NestBox box;        // of the boundary
  NestBox own_box;    // of the piece itself: what must lie on the strip
  NestPoint inner;    // a point inside
  // The discs in columns.
  std::vector<float> pole_x, pole_y, pole_radius;
  double area = 0;     // of the piece itself
  float diameter = 0;  // the longer side of the box
  float weight = 0;    // fourth root of the hull's area: what an overlap of this shape counts
};

/// Each item's shapes, by angle.
using PosedItems = std::vector<std::vector<PosedShape>>;
/// `check_stop`, if any, is called before each item; what it throws ends it.
PosedItems posed_items(const NestProblem& problem, const StopCheck& check_stop = never_stop);

/// How much two shapes overlap whose discs say that they do: about the root of the area that is covered twice, times a
/// factor for their size; never 0. After sparrow's overlap proxy (Gardeyn, Wauters 2025). `sure` becomes true where a
/// disc of one meets one of the other, so that they overlap certainly.
double overlap_estimate(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift, bool& sure);

/// Whether the shapes have a point in common: by their outlines, exactly.
bool shapes_meet(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift);

}  // namespace tessera
