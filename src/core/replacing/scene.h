// A hole and who makes room for what comes into it: the part of a window's pieces that a trial changes, and those
// beside it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/relax/relaxation.h"
#include "core/replacing/hole_shape.h"
#include "core/replacing/replacement.h"

namespace tessera {

struct Scene {
  std::vector<RelaxedPiece> pieces;      // that make room, then those beside them, which stand still, then new ones
  std::vector<const HoleShape*> shapes;  // of the pieces
  std::vector<std::size_t> active;       // places of those that move

  void add(const HoleShape& shape, const Similarity& canvas_from_shape, const PoseRange& poses, bool moves);
};

class SceneRelaxation {
 public:
  /// The window outlives it.
  explicit SceneRelaxation(const ReplacementWindow& window);

  const EdgeDistance& edge() const { return edge_; }

  /// A few sweeps that tell nearly as well as all of them how it will end.
  void soften(Scene& scene) const;
  void come_to_rest(Scene& scene) const;
  /// What its moving pieces cost: depth in each other and beyond the edge, and what is covered twice; less their area.
  double energy_px2(const Scene& scene) const;

 private:
  EdgeDistance edge_;
  Relaxation relaxation_;
  float first_step_px_;
};

}  // namespace tessera
