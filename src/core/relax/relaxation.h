// Joint relaxation: the pieces of a collage move, turn and scale together and grow into the gaps between them.
//
// It minimises an energy, px², with three terms: -(sum of scale²), which is the pieces' area; for each two pieces, in
// both directions, stiffness / 4 · sum of length · depth² over the boundary samples of one, by the distance field of
// the other; for the canvas' edge, stiffness · the same sum. In equilibrium a piece with neighbours all round lies 1 /
// stiffness px deep in them. Gauss-Seidel over the pieces, with one Gauss-Newton step for each piece in a sweep.
//
// The same pieces give the same bits on every machine: only + - * / and square roots, in a fixed order.
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
  PoseRange poses;     // the allowed poses
  bool fixed = false;  // the piece never moves, but others are in contact with it
};

/// Distances, px, below which pieces repel each other and the edge; negative: a depth.
struct ContactDistances {
  float soft_px = 0;
  float hard_px = 0;  // below this the hard stiffness acts, too

  /// Pieces whose boxes are farther apart than this do not affect each other.
  float reach_px() const { return std::max(soft_px, 0.f); }
};

/// Parameters from the first sweep to the last: contacts become stiffer and steps shorter. So pieces first pass each
/// other's tips and find their final poses at the end.
struct RelaxationSchedule {
  int sweeps = 0;
  float first_stiffness = 0;
  float last_stiffness = 0;
  float first_step_px = 0;  // length limit of a step; turn and growth are measured as in PieceMovement
  float last_step_px = 0;
  float hard_stiffness = 0;
  bool growing = true;  // false: the pieces' area has no value, they only make way
};

class Relaxation {
 public:
  /// Relaxes on the canvas of `free`, without regard to its pieces. `free` must outlive this object.
  Relaxation(const FreeField& free, const ContactDistances& distances) : Relaxation(EdgeDistance(free), distances) {}
  Relaxation(const EdgeDistance& edge, const ContactDistances& distances) : edge_(edge), distances_(distances) {}

  /// Moves the pieces whose indices are in `active` (in any order) and that are not fixed. Afterwards their centres lie
  /// in the one period of a seamless canvas. Calls `check_stop` between sweeps; if that throws, the pieces are
  /// unchanged.
  void relax(std::vector<RelaxedPiece>& pieces, std::vector<std::size_t> active, const RelaxationSchedule& schedule,
             const StopCheck& check_stop) const;

  /// The energy of all pieces; depths count from soft_px on, without the hard stiffness.
  double energy_px2(const std::vector<RelaxedPiece>& pieces, float stiffness) const;

  /// The part of the energy that depends on the poses of `active` (indices).
  double energy_px2(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active, float stiffness,
                    float hard_stiffness = 0) const;

  /// The derivative of the energy by each of the piece's movements (order of PieceMovement), px² per px.
  std::array<double, 4> energy_gradient(const std::vector<RelaxedPiece>& pieces, std::size_t piece,
                                        float stiffness) const;

 private:
  EdgeDistance edge_;
  ContactDistances distances_;
};

}  // namespace tessera
