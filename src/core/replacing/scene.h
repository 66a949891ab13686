// The pieces of a trial: those that make room for a hole's new pieces, and those beside them.
#pragma once

#include <cstddef>
#include <vector>

#include "core/relax/relaxation.h"
#include "core/replacing/hole_shape.h"
#include "core/replacing/replacement.h"

namespace tessera {

struct Scene {
  std::vector<RelaxedPiece> pieces;      // pieces that make room, then still ones beside them, then new ones
  std::vector<const HoleShape*> shapes;  // of the pieces
  std::vector<std::size_t> active;       // indices of the pieces that move

  void add(const HoleShape& shape, const Similarity& canvas_from_shape, const PoseRange& poses, bool moves);
};

class SceneRelaxation {
 public:
  /// The window must outlive this object.
  explicit SceneRelaxation(const ReplacementWindow& window);

  const EdgeDistance& edge() const { return edge_; }

  /// A few soft sweeps, whose energy predicts that of the full relaxation well.
  void relax_softly(Scene& scene) const;
  void relax_fully(Scene& scene) const;
  /// The cost of the moving pieces: depth in each other and beyond the edge, and area covered twice; less their area.
  double energy_px2(const Scene& scene) const;

 private:
  EdgeDistance edge_;
  Relaxation relaxation_;
  float first_step_px_;
};

}  // namespace tessera
