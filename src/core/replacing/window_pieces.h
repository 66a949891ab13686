// The pieces of a window during replacement: their poses, and whether they may move.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/replacing/hole.h"
#include "core/replacing/hole_shape.h"
#include "core/replacing/replacement.h"
#include "core/replacing/scene.h"

namespace tessera {

using HoleShapes = std::map<ShapeId, const HoleShape*>;

class WindowPieces {
 public:
  struct WindowPieceState {
    WindowPiece piece;
    const HoleShape* shape = nullptr;
    ContactPiece laid;
    std::uint32_t from = ReplacedPiece::kNew;  // index in ReplacementWindow::moving
    bool still = false;
  };

  /// All arguments must outlive this object.
  WindowPieces(const ReplacementWindow& window, const HoleShapes& shapes, const EdgeDistance& edge);

  const WindowPieceState& operator[](std::size_t i) const { return standing_[i]; }
  /// Whether the piece may move: it does not stand still, and its box lies inside the window.
  bool may_move(std::size_t i) const;
  bool stays_inside(const Scene& scene) const;

  /// Distance to the nearest piece or the edge, at most `most_px`.
  float openness_px(Vec2 p, float most_px) const;
  /// The pieces nearer than `most_px` to the point, with their distances, nearest first.
  std::vector<std::pair<float, std::size_t>> nearest(Vec2 p, float most_px) const;
  /// Whether the outline of piece `i` is nearer than `reach_px` to that of any of `others`.
  bool any_near(std::size_t i, const std::vector<std::size_t>& others, float reach_px) const;
  /// The largest distance from `p` to a boundary sample of these pieces.
  float farthest_px(Vec2 p, const std::vector<std::size_t>& pieces) const;

  /// The scene with the pieces `moving`, then the pieces that stand still beside them, beside `out` or beside the boxes
  /// `incoming`. It does not contain `out`.
  Scene scene_of(const std::vector<std::size_t>& moving, const std::vector<std::size_t>& out,
                 const std::vector<Box>& incoming) const;
  /// The free area around the centre once `out` is taken out.
  Hole hole_of(Vec2 centre_px, const std::vector<std::size_t>& out, float half_px) const;

  void move(std::size_t i, const Similarity& canvas_from_shape);
  /// Removes these pieces; the indices of others change.
  void take_out(std::vector<std::size_t> pieces);
  void add(const IncomingShape& shape, const Similarity& canvas_from_shape);

  /// All pieces except those that stand still: the old ones first, in their order.
  std::vector<ReplacedPiece> replaced() const;

 private:
  void stand(const WindowPiece& piece, std::uint32_t from, bool still);
  bool is_inside(const Box& box) const;

  const ReplacementWindow& window_;
  const HoleShapes& shapes_;
  const EdgeDistance& edge_;
  std::vector<WindowPieceState> standing_;
};

}  // namespace tessera
