// One Gauss-Newton step of one piece: the movement, turn and growth that reduce the energy of its contacts.
#pragma once

#include "core/geometry/similarity.h"
#include "core/matching/pose_range.h"
#include "core/relax/contacts.h"

namespace tessera {

/// A movement in px. Turn and growth are given as the movement of a point at the distance of the scale from the centre.
struct PieceMovement {
  float shift_x = 0;
  float shift_y = 0;
  float turn = 0;
  float growth = 0;

  float largest() const;
};

/// The quadratic energy of a piece as a symmetric 4 x 4 system, in the order of PieceMovement.
class RelaxationStep {
 public:
  explicit RelaxationStep(const Similarity& canvas_from_shape)
      : centre_(canvas_from_shape.translation()),
        scale_px_(canvas_from_shape.scale()) {}

  /// Adds stiffness / 2 · length · depth² for a sample of this piece that lies in something that does not move.
  void add_own(const Contact& contact, float depth_px, float stiffness);
  /// Adds stiffness / 2 · length · depth² for a sample of another piece that lies in this one.
  void add_others(const Contact& contact, float depth_px, float stiffness);
  /// Adds the energy -scale² of the area.
  void add_growth();
  /// Adds stiffness / 2 · |movement|².
  void add_damping(float stiffness);

  const double (&gradient() const)[4] { return gradient_; }

  /// The movement that minimises the sum while the pose stays within `poses`.
  PieceMovement solved(const Similarity& canvas_from_shape, const PoseRange& poses) const;

 private:
  void add(const float (&change)[4], float depth_px, float weight);

  Vec2 centre_;
  float scale_px_;
  double matrix_[4][4] = {};  // lower half
  double gradient_[4] = {};
};

/// The pose after `part` (0..1) of the movement, within `poses`.
Similarity moved(const Similarity& canvas_from_shape, const PieceMovement& movement, float part,
                 const PoseRange& poses);

}  // namespace tessera
