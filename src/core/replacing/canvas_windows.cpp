#include "core/replacing/canvas_windows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/relax/schedules.h"
#include "core/replacing/window_cuts.h"
#include "core/replacing/window_edge.h"

namespace tessera {
namespace {

constexpr float kWindowSizes = 6;    // least width of a window in middle sizes,
constexpr float kWindowLargest = 3;  // and in largest sizes; the larger one counts
constexpr float kSeenBeside = 0.5f;  // of the middle size: a window includes pieces nearer than this
constexpr float kBeyond_px = 64;     // nothing lies farther outside the canvas' nodes

float middle_px(const PieceSettings& p) { return std::sqrt(p.min_scale_px * p.max_scale_px); }

Box canvas_box(const FreeField& free) {
  const Window& nodes = free.grid().one_period();
  const Vec2 origin = free.field().origin;
  Box box{origin + Vec2{float(nodes.x0), float(nodes.y0)}, origin + Vec2{float(nodes.x1), float(nodes.y1)}};
  const Period& period = free.grid().period();
  const Vec2 beyond{period.x_px > 0 ? 0 : kBeyond_px, period.y_px > 0 ? 0 : kBeyond_px};
  return {box.low - beyond, box.high + beyond};
}

bool holds(const Box& outer, const Box& inner) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

}  // namespace

float least_window_px(const PieceSettings& pieces) {
  return std::max(kWindowSizes * middle_px(pieces), kWindowLargest * pieces.max_scale_px);
}

std::vector<PosedPiece> posed_pieces(const std::vector<Placement>& placements, ShapeSource& shapes,
                                     const PosesOf& poses_of, const StopCheck& check_stop) {
  std::vector<PosedPiece> all;
  for (const Placement& p : placements) {
    check_stop();
    std::vector<Vec2> points;
    for (const Vec2 point : shapes.model(p.shape).boundary) points.push_back(p.canvas_from_shape.apply(point));
    all.push_back({{p.shape, shapes.silhouette(p.shape), p.canvas_from_shape, poses_of(p)}, bounding_box(points)});
  }
  return all;
}

std::vector<CutWindow> CanvasWindows::cut(const std::vector<PosedPiece>& all, std::size_t given, float part_x,
                                          float part_y, const StopCheck& check_stop) const {
  std::vector<CutWindow> cuts;
  for (const Box& box :
       cut_into_windows(canvas_box(free_), free_.grid().period(), least_window_px(pieces_), part_x, part_y)) {
    check_stop();
    CutWindow made = cut_one(box, all, given);
    if (!made.moving.empty()) cuts.push_back(std::move(made));
  }
  return cuts;
}

/// Makes one window. On a seamless canvas it may contain or meet any image of a piece.
CutWindow CanvasWindows::cut_one(const Box& box, const std::vector<PosedPiece>& all, std::size_t given) const {
  CutWindow made;
  made.window.box = box;
  const std::vector<Vec2> offsets = free_.grid().period().offsets();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const Vec2 offset : offsets) {
      const Box lies{all[i].box.low + offset, all[i].box.high + offset};
      if (!within_reach(box, lies, kSeenBeside * middle_px(pieces_))) continue;
      WindowPiece piece = all[i].piece;
      piece.canvas_from_shape = moved(piece.canvas_from_shape, offset);
      if (i >= given && holds(box, lies)) {
        made.moving.push_back(i);
        made.window.moving.push_back(piece);
      } else {
        made.window.still.push_back(piece);
      }
    }
  }
  made.window.elsewhere = copies_around(box, all, made.moving);
  return made;
}

/// The pieces, and their images on a seamless canvas, that may count as copies in the window, without those at the
/// indices `but`.
std::vector<PlacedDrawing> CanvasWindows::copies_around(const Box& box, const std::vector<PosedPiece>& all,
                                                        const std::vector<std::size_t>& but) const {
  const float reach_px = repetition_.reach_sizes * pieces_.max_scale_px;
  const std::vector<Vec2> offsets = free_.grid().period().offsets();
  std::vector<PlacedDrawing> around;
  auto skipped = but.begin();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (skipped != but.end() && *skipped == i) {
      ++skipped;
      continue;
    }
    for (const Vec2 offset : offsets) {
      PlacedDrawing piece = placed_drawing(all[i].piece.drawing, all[i].piece.canvas_from_shape);
      piece.centre_px = piece.centre_px + offset;
      if (within_reach(box, {piece.centre_px, piece.centre_px}, reach_px)) around.push_back(piece);
    }
  }
  return around;
}

void CanvasWindows::complete(ReplacementWindow& window) const {
  window.edge = edge_around(window.box, free_, pieces_);
  window.distances = contact_distances(pieces_);
  window.least_scale_px = pieces_.min_scale_px;
  window.most_scale_px = pieces_.max_scale_px;
  window.repetition = repetition_;
}

}  // namespace tessera
