// Joint relaxation: the pieces of a collage move, turn and scale together until they grew into the gaps between them.
//
// What becomes less is the energy, px²: -(sum of scale²), which is the pieces' area; for each two pieces, both ways,
// + stiffness / 4 · sum of length · depth² over the boundary samples of the one, by the distance field of the other;
// for the canvas' edge + stiffness · the same sum. At rest a piece with neighbours all round lies 1 / stiffness px deep
// in them. Gauss-Seidel over the pieces, one Gauss-Newton step each a sweep.
//
// The same pieces give the same bits on every machine: + - * / and square roots in a fixed order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "core/matching/pose_range.h"
#include "core/relax/contact_shape.h"
#include "core/relax/edge_distance.h"

namespace tessera {

struct RelaxedPiece {
  const ContactShape* shape = nullptr;  // outlives the piece
  Similarity canvas_from_shape;
  PoseRange poses;     // what the pose may be
  bool fixed = false;  // it never moves, but others feel it
};

/// From which distance on pieces feel each other and the edge, px; negative: so deep.
struct ContactDistances {
  float soft_px = 0;
  float hard_px = 0;  // what is nearer than this is pushed away with the hard stiffness, too

  /// Pieces whose boxes are no nearer than this do not feel each other.
  float reach_px() const { return std::max(soft_px, 0.f); }
};

/// From the first sweep to the last: contacts become stiffer and steps shorter, so that pieces pass each other's tips
/// first and come to rest in the end.
struct RelaxationSchedule {
  int sweeps = 0;
  float first_stiffness = 0;
  float last_stiffness = 0;
  float first_step_px = 0;  // the farthest that a step leads, turn and growth measured as in PieceMovement
  float last_step_px = 0;
  float hard_stiffness = 0;
  bool growing = true;  // false: the pieces' area is worth nothing, they only make way
};

class Relaxation {
 public:
  /// On the canvas of this field, whatever lies in it. It outlives the relaxation.
  Relaxation(const FreeField& free, const ContactDistances& distances) : Relaxation(EdgeDistance(free), distances) {}
  Relaxation(const EdgeDistance& edge, const ContactDistances& distances) : edge_(edge), distances_(distances) {}

  /// Moves those of `pieces` that `active` (indices, in any order) names and that are not fixed; afterwards their
  /// centres lie in the one period of a seamless canvas. `check_stop` is called between sweeps; where it throws, the pieces
  /// are left as they are.
  void relax(std::vector<RelaxedPiece>& pieces, std::vector<std::size_t> active, const RelaxationSchedule& schedule,
             const StopCheck& check_stop) const;

  /// Of all pieces, depths counted from soft_px on, without what is hard.
  double energy_px2(const std::vector<RelaxedPiece>& pieces, float stiffness) const;

  /// As far as it depends on the poses of `active` (indices).
  double energy_px2(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active, float stiffness,
                    float hard_stiffness = 0) const;

  /// By how much the energy changes with each of the piece's movements (order of PieceMovement), px² a px.
  std::array<double, 4> energy_gradient(const std::vector<RelaxedPiece>& pieces, std::size_t piece,
                                        float stiffness) const;

 private:
  EdgeDistance edge_;
  ContactDistances distances_;
};

}  // namespace tessera
