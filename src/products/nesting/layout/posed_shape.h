// A piece's shape at one of its angles, ready to be compared with others.
#pragma once

#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_poles.h"
#include "products/nesting/layout/nest_problem.h"

namespace tessera {

struct PosedShape {
  NestRing boundary;  // of the search outline; the first point is repeated at its end
  NestRing body;      // the outline before it is grown
  NestBox box;        // bounding box of the boundary
  NestBox own_box;    // bounding box of the piece itself, which must lie on the strip
  NestPoint inner;    // a point inside
  // The discs in columns.
  std::vector<float> pole_x, pole_y, pole_radius;
  double area = 0;     // of the piece itself
  float diameter = 0;  // the longer side of the box
  float weight = 0;    // fourth root of the hull's area: the weight of overlaps of this shape
};

/// Each item's shapes, by angle.
using PosedItems = std::vector<std::vector<PosedShape>>;
/// Makes the shapes. `check_stop` is called before each item; what it throws ends the work.
PosedItems posed_items(const NestProblem& problem, const StopCheck& check_stop = never_stop);

/// An estimate of how much two shapes overlap, from their discs: about the square root of the doubly covered area, times a
/// factor for their size; never 0. After sparrow's overlap proxy (Gardeyn, Wauters 2025). `sure` becomes true where discs
/// of both meet, so that the shapes certainly overlap.
double overlap_estimate(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift, bool& sure);

/// Whether the shapes have a point in common, exactly, by their outlines.
bool shapes_meet(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift);

}  // namespace tessera
