// Writes laid pieces of a puzzle in the format that start.pieces of a job and tessera card read.
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

/// A FeatureCollection like pieces.geojson of a result, without the data that only a run has.
std::string puzzle_geojson(const std::vector<LaidPuzzlePiece>& pieces);

}  // namespace tessera
