// Replacement trials: in a window of the canvas single pieces are taken out, others are put into the hole, and their
// neighbours make room (core/relax). Windows do not touch each other, so that any rank may work on any of them; what
// comes of one follows from what is in here alone. Canvas px.
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
  ShapeId drawing{};  // pieces of one drawing repeat each other, mirrored or in other colours (ShapeSource::silhouette)
  Similarity canvas_from_shape;
  PoseRange poses;

  friend bool operator==(const WindowPiece&, const WindowPiece&) = default;
};

/// A shape that may come in, in one of its stances.
struct IncomingShape {
  ShapeId shape{};
  ShapeId drawing{};
  PoseRange poses;
  float weight = 1;  // how often it is drawn, of 1

  friend bool operator==(const IncomingShape&, const IncomingShape&) = default;
};

/// What it costs that drawings repeat themselves (core/replacing/repetition.h); nothing as it is.
struct RepetitionCosts {
  double area = 0;            // of an area, for each e-fold by which its drawing covers more than
  double even_share_px2 = 1;  // so much
  double nearness = 0;        // of the smaller one's area, for two copies at one place, falling to nothing
  float reach_sizes = 0;      // so many of their mean sizes (geometric) apart

  friend bool operator==(const RepetitionCosts&, const RepetitionCosts&) = default;
};

struct DrawingArea {
  ShapeId drawing{};
  double area_px2 = 0;  // of its pieces on the whole canvas

  friend bool operator==(const DrawingArea&, const DrawingArea&) = default;
};

/// What the eye sees of a piece that repeats another: which drawing it is, where and how large.
struct PlacedDrawing {
  ShapeId drawing{};
  Vec2 centre_px;
  float scale_px = 0;

  friend bool operator==(const PlacedDrawing&, const PlacedDrawing&) = default;
};

inline PlacedDrawing placed_drawing(ShapeId drawing, const Similarity& canvas_from_shape) {
  return {drawing, canvas_from_shape.translation(), canvas_from_shape.scale()};
}

/// Distance to the canvas' edge, px, positive inside: at node (i, j), which lies at (origin + (i, j)) times node_px.
/// Beyond the nodes it falls with the way there. What is farther away than anything in the window may feel has any
/// distance that is as far.
struct EdgeField {
  CanvasField distance;
  float node_px = 1;
};

struct ReplacementWindow {
  Box box;  // what moves stays within it, so much before its edges as pieces feel each other
  EdgeField edge;
  ContactDistances distances;
  float least_scale_px = 0;  // of all pieces of the job
  float most_scale_px = 0;
  RepetitionCosts repetition;
  std::vector<WindowPiece> moving;
  std::vector<WindowPiece> still;  // that reach into the window, or nearly
  std::vector<IncomingShape> incoming;
  std::vector<DrawingArea> drawn;        // every drawing of `moving` and `incoming`, ascending
  std::vector<PlacedDrawing> elsewhere;  // pieces that do not move in it, of any drawing, as far as copies are felt
  std::uint64_t random = 0;              // what the draws follow from
  std::uint32_t trials = 0;
  float first_temperature_px2 = 0;  // falls evenly to the last: what a loss of so much energy is worth a risk of 1 in e
  float last_temperature_px2 = 0;
};

/// Between the least and the most scale, as far from both: what lengths of replacing are measured by.
inline float middle_px(const ReplacementWindow& window) {
  return std::sqrt(window.least_scale_px * window.most_scale_px);
}

struct ReplacedPiece {
  static constexpr std::uint32_t kNew = UINT32_MAX;

  ShapeId shape{};
  Similarity canvas_from_shape;
  std::uint32_t from = kNew;  // place in ReplacementWindow::moving

  friend bool operator==(const ReplacedPiece&, const ReplacedPiece&) = default;
};

struct ReplacementOutcome {
  std::vector<ReplacedPiece> pieces;  // that stand instead of the moving ones: those of old first, in their order
  std::uint32_t kept = 0;             // trials

  friend bool operator==(const ReplacementOutcome&, const ReplacementOutcome&) = default;
};

}  // namespace tessera
