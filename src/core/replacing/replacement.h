// Replacement trials: in a window of the canvas single pieces are taken out, others are put into the hole, and their
// neighbours make room (core/relax). Windows do not touch each other, so any rank may work on any of them. The outcome
// of a window follows only from the data in this file. Canvas px.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/matching/pose_range.h"
#include "core/relax/relaxation.h"
#include "core/shape/shape_id.h"

namespace tessera {

struct WindowPiece {
  ShapeId shape{};
  ShapeId drawing{};  // pieces of one drawing repeat each other, also mirrored or recoloured (silhouette())
  Similarity canvas_from_shape;
  PoseRange poses;

  friend bool operator==(const WindowPiece&, const WindowPiece&) = default;
};

/// A shape that may come in, with one of its stances.
struct IncomingShape {
  ShapeId shape{};
  ShapeId drawing{};
  PoseRange poses;
  float weight = 1;  // probability of being drawn

  friend bool operator==(const IncomingShape&, const IncomingShape&) = default;
};

/// The costs of repeated drawings (core/replacing/repetition.h). The default costs nothing.
struct RepetitionCosts {
  double area = 0;            // fraction of an area that it costs per e-fold by which its drawing covers more than
  double even_share_px2 = 1;  // this area
  double nearness = 0;        // fraction of the smaller one's area that two copies at one place cost; it falls to 0
  float reach_sizes = 0;      // at this distance, in mean sizes (geometric) of the two

  friend bool operator==(const RepetitionCosts&, const RepetitionCosts&) = default;
};

struct DrawingArea {
  ShapeId drawing{};
  double area_px2 = 0;  // of all pieces of the drawing on the whole canvas

  friend bool operator==(const DrawingArea&, const DrawingArea&) = default;
};

/// A piece as it counts for repetition: its drawing, place and size.
struct PlacedDrawing {
  ShapeId drawing{};
  Vec2 centre_px;
  float scale_px = 0;

  friend bool operator==(const PlacedDrawing&, const PlacedDrawing&) = default;
};

inline PlacedDrawing placed_drawing(ShapeId drawing, const Similarity& canvas_from_shape) {
  return {drawing, canvas_from_shape.translation(), canvas_from_shape.scale()};
}

/// Distance to the canvas' edge, px, positive inside. Node (i, j) lies at (origin + (i, j)) times node_px. Beyond the
/// nodes the distance falls with the way. Nodes too far from the edge to affect the window may have any distance that
/// is as far.
struct EdgeField {
  CanvasField distance;
  float node_px = 1;
};

struct ReplacementWindow {
  Box box;  // moving pieces stay within it, with a margin of half the reach of contacts
  EdgeField edge;
  ContactDistances distances;
  float least_scale_px = 0;  // of all pieces of the job
  float most_scale_px = 0;
  RepetitionCosts repetition;
  std::vector<WindowPiece> moving;
  std::vector<WindowPiece> still;  // pieces that reach into the window or lie near it, and stand still
  std::vector<IncomingShape> incoming;
  std::vector<DrawingArea> drawn;        // every drawing of `moving` and `incoming`, ascending
  std::vector<PlacedDrawing> elsewhere;  // pieces of any drawing that do not move here, as far as copies matter
  std::uint64_t random = 0;              // seed of the draws
  std::uint32_t trials = 0;
  /// Temperature of the first trial: a loss of this energy is accepted with probability 1 / e. It falls evenly to the
  /// last trial's.
  float first_temperature_px2 = 0;
  float last_temperature_px2 = 0;
};

/// The geometric mean of the least and the most scale. Lengths of replacement are multiples of it.
inline float middle_px(const ReplacementWindow& window) {
  return std::sqrt(window.least_scale_px * window.most_scale_px);
}

struct ReplacedPiece {
  static constexpr std::uint32_t kNew = UINT32_MAX;

  ShapeId shape{};
  Similarity canvas_from_shape;
  std::uint32_t from = kNew;  // index in ReplacementWindow::moving

  friend bool operator==(const ReplacedPiece&, const ReplacedPiece&) = default;
};

struct ReplacementOutcome {
  std::vector<ReplacedPiece> pieces;  // pieces that replace the moving ones: the old ones first, in their order
  std::uint32_t kept = 0;             // number of trials that were kept

  friend bool operator==(const ReplacementOutcome&, const ReplacementOutcome&) = default;
};

}  // namespace tessera
