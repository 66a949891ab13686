// What several descriptors take of curves: a fixed number of even points of all of them.
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

/// `count` points in all, shared out by the curves' lengths, so that a curve that is short may have none. Tangents are
/// those of the curve smoothed by a hundredth of the length of all curves.
EvenPoints even_points(const std::vector<Curve>& curves, int count);

float length_of_all(const std::vector<Curve>& curves);

/// One closed curve through all curves: the longest closed one, or, where arcs are longer than that, all arcs, each
/// joined to the next by a straight line, in the order in which they are given.
Curve closed_boundary(const std::vector<Curve>& curves);

/// How well the rows of `query` go, in their order, onto rows of `known` that follow one another on a closed curve: the
/// least mean difference by dynamic time warping, which may begin and end anywhere on the closed curve. Both have rows of
/// `row` numbers; a difference of rows is the mean of those of their numbers. The orders must agree.
float warped_difference(const std::vector<float>& query, const std::vector<float>& known, std::size_t row);

}  // namespace tessera::bench
