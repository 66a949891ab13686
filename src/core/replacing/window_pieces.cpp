#include "core/replacing/window_pieces.h"

#include <algorithm>

namespace tessera {
namespace {

constexpr float kBeside = 0.4f;  // of the middle size: pieces nearer than this to moving ones are part of the scene
constexpr std::size_t kOutlineStep = 4;  // every fourth point of an outline is tested
constexpr float kLeastCell_px = 1.5f;
constexpr float kCellsPerScale = 20;

bool is_of(const std::vector<std::size_t>& list, std::size_t i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

}  // namespace

WindowPieces::WindowPieces(const ReplacementWindow& window, const HoleShapes& shapes, const EdgeDistance& edge)
    : window_(window),
      shapes_(shapes),
      edge_(edge) {
  for (std::size_t i = 0; i < window.moving.size(); ++i) stand(window.moving[i], std::uint32_t(i), false);
  for (const WindowPiece& piece : window.still) stand(piece, ReplacedPiece::kNew, true);
}

void WindowPieces::stand(const WindowPiece& piece, std::uint32_t from, bool still) {
  WindowPieceState s{piece, shapes_.at(piece.shape), {}, from, still};
  s.laid.lay(s.shape->contact, piece.canvas_from_shape);
  standing_.push_back(std::move(s));
}

bool WindowPieces::may_move(std::size_t i) const { return !standing_[i].still && is_inside(standing_[i].laid.box); }

bool WindowPieces::is_inside(const Box& box) const {
  const float margin_px = 0.5f * window_.distances.reach_px();
  return box.low.x >= window_.box.low.x + margin_px && box.low.y >= window_.box.low.y + margin_px &&
         box.high.x <= window_.box.high.x - margin_px && box.high.y <= window_.box.high.y - margin_px;
}

bool WindowPieces::stays_inside(const Scene& scene) const {
  return std::all_of(scene.active.begin(), scene.active.end(), [&](std::size_t i) {
    ContactPiece laid;
    laid.lay(*scene.pieces[i].shape, scene.pieces[i].canvas_from_shape);
    return is_inside(laid.box);
  });
}

float WindowPieces::openness_px(Vec2 p, float most_px) const {
  float open = std::min(most_px, edge_.at(p).value);
  for (const WindowPieceState& s : standing_) {
    if (within_reach(s.laid.box, {p, p}, std::max(open, 0.f))) open = std::min(open, s.laid.distance(p).value);
  }
  return open;
}

std::vector<std::pair<float, std::size_t>> WindowPieces::nearest(Vec2 p, float most_px) const {
  std::vector<std::pair<float, std::size_t>> near;
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    if (!within_reach(standing_[i].laid.box, {p, p}, most_px)) continue;
    const float distance_px = standing_[i].laid.distance(p).value;
    if (distance_px < most_px) near.emplace_back(distance_px, i);
  }
  std::sort(near.begin(), near.end());
  return near;
}

bool WindowPieces::any_near(std::size_t i, const std::vector<std::size_t>& others, float reach_px) const {
  const ContactPiece& piece = standing_[i].laid;
  for (const std::size_t o : others) {
    const ContactPiece& other = standing_[o].laid;
    if (!within_reach(other.box, piece.box, reach_px)) continue;
    for (std::size_t k = 0; k < piece.points.size(); k += kOutlineStep) {
      if (other.distance(piece.points[k]).value < reach_px) return true;
    }
  }
  return false;
}

float WindowPieces::farthest_px(Vec2 p, const std::vector<std::size_t>& pieces) const {
  float farthest = 0;
  for (const std::size_t i : pieces) {
    for (const Vec2 point : standing_[i].laid.points) farthest = std::max(farthest, norm(point - p));
  }
  return farthest;
}

Scene WindowPieces::scene_of(const std::vector<std::size_t>& moving, const std::vector<std::size_t>& out,
                             const std::vector<Box>& incoming) const {
  const auto add = [this](Scene& scene, std::size_t i, bool moves) {
    const WindowPieceState& s = standing_[i];
    scene.add(*s.shape, s.piece.canvas_from_shape, s.piece.poses, moves);
  };
  Scene scene;
  for (const std::size_t i : moving) add(scene, i, true);
  const float reach_px = kBeside * middle_px(window_);
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    if (is_of(moving, i) || is_of(out, i)) continue;
    const auto beside_box = [&](const Box& box) { return within_reach(standing_[i].laid.box, box, reach_px); };
    const auto beside = [&](std::size_t j) { return beside_box(standing_[j].laid.box); };
    if (std::any_of(moving.begin(), moving.end(), beside) || std::any_of(out.begin(), out.end(), beside) ||
        std::any_of(incoming.begin(), incoming.end(), beside_box)) {
      add(scene, i, false);
    }
  }
  return scene;
}

Hole WindowPieces::hole_of(Vec2 centre_px, const std::vector<std::size_t>& out, float half_px) const {
  Hole hole(centre_px, half_px, std::max(kLeastCell_px, window_.least_scale_px / kCellsPerScale), edge_);
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    if (!is_of(out, i) && within_reach(standing_[i].laid.box, {centre_px, centre_px}, half_px)) {
      hole.add(standing_[i].laid);
    }
  }
  return hole;
}

void WindowPieces::move(std::size_t i, const Similarity& canvas_from_shape) {
  WindowPieceState& s = standing_[i];
  s.piece.canvas_from_shape = canvas_from_shape;
  s.laid.lay(s.shape->contact, canvas_from_shape);
}

void WindowPieces::take_out(std::vector<std::size_t> pieces) {
  std::sort(pieces.rbegin(), pieces.rend());
  for (const std::size_t i : pieces) standing_.erase(standing_.begin() + std::ptrdiff_t(i));
}

void WindowPieces::add(const IncomingShape& shape, const Similarity& canvas_from_shape) {
  stand({shape.shape, shape.drawing, canvas_from_shape, shape.poses}, ReplacedPiece::kNew, false);
}

std::vector<ReplacedPiece> WindowPieces::replaced() const {
  std::vector<ReplacedPiece> pieces;
  for (const bool old : {true, false}) {
    for (const WindowPieceState& s : standing_) {
      if (s.still || (s.from != ReplacedPiece::kNew) != old) continue;
      pieces.push_back({s.piece.shape, s.piece.canvas_from_shape, s.from});
    }
  }
  return pieces;
}

}  // namespace tessera
