// The parts of two sets of curves that follow one another, when one set is laid onto the other.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/curve.h"

namespace tessera {

/// A part of a curve, as arclengths from its first point, from < to. `to` exceeds the curve's length if the part
/// continues beyond the first point of a closed curve.
struct CurvePart {
  std::size_t curve = 0;  // index in the set
  float from = 0;
  float to = 0;

  float length() const { return to - from; }
  friend bool operator==(const CurvePart&, const CurvePart&) = default;
};

/// A part of a curve of B that follows a part of one of A.
struct MatchedRun {
  CurvePart of_a;
  CurvePart of_b;
  bool reversed = false;  // B has the opposite direction of A
};

struct RunSettings {
  float reach = 0;             // largest distance, in units of A
  float least_length = 0;      // of a run, in units of A
  bool any_direction = false;  // curves without an interior may follow one another in opposite directions
};

/// The runs in order of B's curves. `a`, `b`: evenly spaced points (even_curves()). A run ends where the distance or
/// the angle (more than 37 degrees) is too large.
std::vector<MatchedRun> matched_runs(const std::vector<Curve>& a, const std::vector<Curve>& b,
                                     const Similarity& a_from_b, const RunSettings& settings);

/// The points of a curve from one arclength to the other, including both ends.
std::vector<Vec2> points_of(const Curve& curve, const CurvePart& part);

/// The length of A that the runs cover; parts in several runs count once. Runs do not overlap on B.
float covered_length_of_a(const std::vector<Curve>& a, const std::vector<MatchedRun>& runs);

}  // namespace tessera
