// The pieces of a window while they are replaced: which lie where, and which of them may move.
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
  struct Standing {
    WindowPiece piece;
    const HoleShape* shape = nullptr;
    LaidPiece laid;
    std::uint32_t from = ReplacedPiece::kNew;  // place in ReplacementWindow::moving
    bool still = false;
  };

  /// All outlive the pieces.
  WindowPieces(const ReplacementWindow& window, const HoleShapes& shapes, const EdgeDistance& edge);

  const Standing& operator[](std::size_t i) const { return standing_[i]; }
  /// Whether it may, and lies in the window as a whole.
  bool may_move(std::size_t i) const;
  bool stays_inside(const Scene& scene) const;

  /// Distance to the nearest piece or the edge, no more than `most_px`.
  float openness_px(Vec2 p, float most_px) const;
  /// Pieces by their distance from the point, nearest first, without those that are farther away.
  std::vector<std::pair<float, std::size_t>> nearest(Vec2 p, float most_px) const;
  /// Whether the outline of `i` comes so near to that of any of `others`.
  bool any_near(std::size_t i, const std::vector<std::size_t>& others, float reach_px) const;
  /// The farthest that a point of any of these is from `p`.
  float farthest_px(Vec2 p, const std::vector<std::size_t>& pieces) const;

  /// `moving`, then who stands beside them, beside `out` or where pieces come in, without `out`.
  Scene scene_of(const std::vector<std::size_t>& moving, const std::vector<std::size_t>& out,
                 const std::vector<Box>& incoming) const;
  /// What is free round the centre without `out`.
  Hole hole_of(Vec2 centre_px, const std::vector<std::size_t>& out, float half_px) const;

  void move(std::size_t i, const Similarity& canvas_from_shape);
  /// Indices of others change.
  void take_out(std::vector<std::size_t> pieces);
  void add(const IncomingShape& shape, const Similarity& canvas_from_shape);

  /// All but those that stand still: those of old first, in their order.
  std::vector<ReplacedPiece> replaced() const;

 private:
  void stand(const WindowPiece& piece, std::uint32_t from, bool still);
  bool is_inside(const Box& box) const;

  const ReplacementWindow& window_;
  const HoleShapes& shapes_;
  const EdgeDistance& edge_;
  std::vector<Standing> standing_;
};

}  // namespace tessera
