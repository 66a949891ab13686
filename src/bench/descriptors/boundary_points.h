// Samples of curves that several descriptors use: a fixed number of evenly spaced points of all curves together.
#pragma once

#include <utility>
#include <vector>

#include "core/recognition/curve.h"

namespace tessera::bench {

/// Evenly spaced points of all curves with their unit tangents, one curve after the other.
struct EvenPoints {
  std::vector<Vec2> position;
  std::vector<Vec2> tangent;
};

/// `count` points in total, divided by the curves' lengths: a short curve may have none. Tangents are those of the
/// curve smoothed by a hundredth of the length of all curves.
EvenPoints even_points(const std::vector<Curve>& curves, int count);

float length_of_all(const std::vector<Curve>& curves);

/// One closed curve from all curves: the longest closed one. Where the arcs are longer than that: all arcs in the given
/// order, each joined to the next by a straight line.
Curve closed_boundary(const std::vector<Curve>& curves);

/// The smallest mean difference between the rows of `query` and consecutive rows of `known` in the same order. It uses
/// dynamic time warping; `known` is a closed curve, and the match may begin and end anywhere on it. Rows have `row`
/// numbers; the difference of two rows is the mean difference of their numbers. Both must run in the same direction.
float warped_difference(const std::vector<float>& query, const std::vector<float>& known, std::size_t row);

}  // namespace tessera::bench
