// The parts of two sets of curves that follow one another, where the one set is laid onto the other.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/curve.h"

namespace tessera {

/// A part of a curve, as arclengths from its first point, from < to. `to` is larger than the curve's length where the part
/// goes on beyond the first point of a closed curve.
struct CurvePart {
  std::size_t curve = 0;  // of the set
  float from = 0;
  float to = 0;

  float length() const { return to - from; }
  friend bool operator==(const CurvePart&, const CurvePart&) = default;
};

/// A part of a curve of B that follows a part of one of A.
struct MatchedRun {
  CurvePart of_a;
  CurvePart of_b;
  bool reversed = false;  // B runs against A's direction
};

struct RunSettings {
  float reach = 0;             // largest distance, in units of A
  float least_length = 0;      // of a run, in units of A
  bool any_direction = false;  // curves without an interior may follow one another against their direction
};

/// The runs in order of B's curves. `a`, `b`: of evenly spaced points (even_curves()). A run ends where the distance or the
/// angle (more than 37 degrees) is too large.
std::vector<MatchedRun> matched_runs(const std::vector<Curve>& a, const std::vector<Curve>& b,
                                     const Similarity& a_from_b, const RunSettings& settings);

/// The points of a curve from one arclength to the other, both of these among them.
std::vector<Vec2> points_of(const Curve& curve, const CurvePart& part);

/// The length that the runs cover of A; what several of them cover counts once. Of B none overlap.
float covered_length_of_a(const std::vector<Curve>& a, const std::vector<MatchedRun>& runs);

}  // namespace tessera
