// Pieces of a puzzle where they lie, as start.pieces of a job and tessera card read them.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"

namespace tessera {

struct LaidPuzzlePiece {
  std::string shape;  // its name in the library
  Similarity canvas_from_shape;
  std::vector<Vec2> outline_px;  // canvas
};

/// A FeatureCollection as pieces.geojson of a result is one, without what only a run knows.
std::string puzzle_geojson(const std::vector<LaidPuzzlePiece>& pieces);

}  // namespace tessera
