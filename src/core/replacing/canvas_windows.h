// Cuts windows of replacement trials (replacement.h) out of a canvas with its pieces. Canvas px.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/matching/pose_range.h"
#include "core/replacing/replacement.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// The least width and height of a window for pieces of these sizes, as cut_into_windows takes it.
float least_window_px(const PieceSettings& pieces);

/// A piece with its allowed poses and the bounding box of its boundary points.
struct PosedPiece {
  WindowPiece piece;
  Box box;
};

/// Returns the allowed poses of a piece.
using PosesOf = std::function<PoseRange(const Placement&)>;

/// The placements as posed pieces, in their order. Calls `check_stop` before each, which may throw.
std::vector<PosedPiece> posed_pieces(const std::vector<Placement>& placements, ShapeSource& shapes,
                                     const PosesOf& poses_of, const StopCheck& check_stop = never_stop);

struct CutWindow {
  ReplacementWindow window;         // its box and pieces; complete() and the caller set the rest
  std::vector<std::size_t> moving;  // indices of window.moving in the list of all pieces
};

class CanvasWindows {
 public:
  /// Windows of the canvas of `free`. `free` must outlive this object, the other arguments need not.
  CanvasWindows(const FreeField& free, const PieceSettings& pieces, const RepetitionCosts& repetition)
      : free_(free),
        pieces_(pieces),
        repetition_(repetition) {}

  /// The windows in which a piece may move, row by row. `part_x`, `part_y` in [0, 1) shift the cuts. A piece moves in
  /// the window that contains its box; the first `given` pieces never move. Calls `check_stop` before each window,
  /// which may throw.
  std::vector<CutWindow> cut(const std::vector<PosedPiece>& all, std::size_t given, float part_x, float part_y,
                             const StopCheck& check_stop = never_stop) const;

  /// Sets a window's data about canvas and job: the canvas' edge, distances, sizes, and the costs of repetition.
  void complete(ReplacementWindow& window) const;

 private:
  CutWindow cut_one(const Box& box, const std::vector<PosedPiece>& all, std::size_t given) const;
  std::vector<PlacedDrawing> copies_around(const Box& box, const std::vector<PosedPiece>& all,
                                           const std::vector<std::size_t>& but) const;

  const FreeField& free_;
  PieceSettings pieces_;
  RepetitionCosts repetition_;
};

}  // namespace tessera
