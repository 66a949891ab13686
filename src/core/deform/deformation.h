// Closes gaps and overlaps of a finished collage by deforming its pieces (paper, section 5, "Deformation", Figs. 21 and
// 23). Boundaries move along their normals to the middle between neighbours. The paper projects every boundary onto its
// Voronoi cell and says that this suits organic shapes only. Here the movement is limited by default, so that shapes
// stay recognisable.
#pragma once

#include <cstddef>
#include <vector>

#include "core/deform/warp.h"
#include "core/field/canvas.h"
#include "core/geometry/similarity.h"
#include "core/settings/settings.h"
#include "core/shape/shape.h"

namespace tessera {

struct DeformablePiece {
  const Shape* shape = nullptr;  // with outline and field
  Similarity canvas_from_shape;
  bool stays = false;  // the piece is not deformed; only its neighbours move
};

struct DeformedPiece {
  Outline outline;         // shape frame
  Warp warp;               // shape frame; maps the shape's outline to `outline`. Without displacements if nothing moved
  float area_ratio = 1;    // after / before
  float pad_distance = 0;  // identity.h
  float farthest_px = 0;   // largest movement of a point of the outline
  float least_jacobian = 1;  // of the warp: above 0, so the warp has no folds
};

/// The deformed pieces in the order of `pieces`. `gap_px` remains between pieces, and between them and the canvas'
/// edge. The same input gives the same bytes on any number of cores.
std::vector<DeformedPiece> deformed_pieces(const Canvas& canvas, const std::vector<DeformablePiece>& pieces,
                                           const DeformSettings& settings, const PadParameters& pad, float gap_px);

}  // namespace tessera
