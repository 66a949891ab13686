// Windows of replacement trials (replacement.h), cut out of a canvas with its pieces. Canvas px.
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

/// The least width and height of a window where pieces have these sizes, as cut_into_windows takes it.
float least_window_px(const PieceSettings& pieces);

/// A piece with the poses that are allowed to it, and the bounding box of its boundary points.
struct PosedPiece {
  WindowPiece piece;
  Box box;
};

/// Says which poses a piece may have.
using PosesOf = std::function<PoseRange(const Placement&)>;

/// The pieces in their order. `check_stop` is called before each and may throw.
std::vector<PosedPiece> posed_pieces(const std::vector<Placement>& placements, ShapeSource& shapes,
                                     const PosesOf& poses_of, const StopCheck& check_stop = never_stop);

struct CutWindow {
  ReplacementWindow window;         // its box and pieces; complete() and the caller set the rest
  std::vector<std::size_t> moving;  // the places of window.moving in the list of all pieces
};

class CanvasWindows {
 public:
  /// Windows of the canvas of `free`. `free` outlives them, the other arguments need not.
  CanvasWindows(const FreeField& free, const PieceSettings& pieces, const RepetitionCosts& repetition)
      : free_(free),
        pieces_(pieces),
        repetition_(repetition) {}

  /// The windows in which a piece may move, row by row; `part_x`, `part_y` in [0, 1): where the cuts lie. A piece moves
  /// in the window that holds its box, but the first `given` pieces never move. `check_stop` is called before each window
  /// and may throw.
  std::vector<CutWindow> cut(const std::vector<PosedPiece>& all, std::size_t given, float part_x, float part_y,
                             const StopCheck& check_stop = never_stop) const;

  /// Sets what a window knows of canvas and job: the canvas' edge, distances, sizes, and what repetition costs.
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
