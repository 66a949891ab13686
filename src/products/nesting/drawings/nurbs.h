// Splines of CAD programs: non-uniform rational B-splines (NURBS), and polygons for them.
#pragma once

#include <cstddef>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct Nurbs {
  int degree = 3;
  std::vector<NestPoint> points;  // control points
  std::vector<double> knots;      // points + degree + 1 numbers; none smaller than the one before
  std::vector<double> weights;    // one for each control point, above 0; empty: all are 1
};

/// The highest degree that is read. CAD programs write 3, and seldom 5.
inline constexpr int kMostNurbsDegree = 25;

/// Whether the numbers of knots, weights and control points fit each other. Otherwise the curve has no points.
bool is_nurbs(const Nurbs& curve);

/// The curve from its first to its last point, within `flatness` of the true curve. It ends early where it would have many
/// more points than `most`. De Boor's algorithm computes each span by itself, so that repeated knots do no harm.
NestRing nurbs_outline(const Nurbs& curve, double flatness, std::size_t most);

}  // namespace tessera
