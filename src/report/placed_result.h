// A result as the page shows it: its pieces with their properties and outlines, on its canvas.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/quality/judged_piece.h"
#include "result/folder/finished_result.h"

namespace tessera {

/// Properties of a piece in pieces.geojson (docs/result-format.md).
struct ShownPiece {
  std::string shape;
  std::string source;
  std::string group;  // empty: none
  double x_px = 0;
  double y_px = 0;
  double scale_px = 0;
  double rotation_deg = 0;
  double score = 0;
  double matched_px = 0;
  bool mirrored = false;
  bool locked = false;
};

struct PlacedResult {
  std::string folder;
  WholeResult whole;
  Canvas canvas;
  std::vector<ShownPiece> pieces;
  std::vector<JudgedPiece> outlines;  // as many
};

/// Throws InputError where the folder holds no whole result, its pieces.geojson is damaged, or its canvas cannot be read
/// any more; EnvironmentError.
PlacedResult read_placed_result(const std::string& folder);

}  // namespace tessera
