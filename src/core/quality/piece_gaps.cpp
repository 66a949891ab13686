#include "core/quality/piece_gaps.h"

#include <algorithm>
#include <cstdint>
#include <memory>

#include "core/geometry/polygon_index.h"

namespace tessera {
namespace {

/// A piece or an image of it. Its index is made when another piece comes near, and kept while it may meet others.
struct PieceImage {
  std::uint32_t piece;
  Vec2 offset_px;  // from the piece's given place
  bool is_image;   // false: the piece itself, with its centre in the first period
  Box box_px;
  std::unique_ptr<const PolygonIndex> index = {};
};

/// Whether a curve of `inner` lies inside `outer`; the boundaries do not cross.
bool has_a_curve_in(const PolygonIndex& inner, const PolygonIndex& outer) {
  const auto& curves = inner.outline().curves;
  return std::any_of(curves.begin(), curves.end(), [&](const auto& curve) { return outer.contains(curve.front()); });
}

/// The distance of two pieces, or `reach_px` if they are farther apart.
float distance_px(const PolygonIndex& a, const PolygonIndex& b, float reach_px) {
  const float boundaries_px = approach_of(a, b, reach_px).distance;
  return boundaries_px <= 0 || has_a_curve_in(a, b) || has_a_curve_in(b, a) ? 0 : boundaries_px;
}

/// A sweep from left to right: each piece is compared with the earlier ones that it may reach.
class GapSweep {
 public:
  GapSweep(const std::vector<JudgedPiece>& pieces, const Period& period, float reach_px)
      : pieces_(pieces),
        reach_px_(reach_px),
        has_near_piece_(pieces.size(), false) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      const Box box = bounding_box(pieces[i].outline_px);
      const Vec2 home = period.wrapped(pieces[i].centre_px) - pieces[i].centre_px;
      for (const Vec2 image : period.offsets()) {
        const Vec2 offset = home + image;
        standing_.push_back({i, offset, image != Vec2{}, {box.low + offset, box.high + offset}});
      }
    }
    std::sort(standing_.begin(), standing_.end(),
              [](const PieceImage& a, const PieceImage& b) { return a.box_px.low.x < b.box_px.low.x; });
  }

  PieceGaps gaps() {
    if (standing_.size() < 2) return {{}, pieces_.empty() ? 0. : 1.};
    smallest_px_ = bound_px();
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < standing_.size(); ++k) {
      std::erase_if(open, [&](std::size_t other) {
        const float far_px = standing_[k].box_px.low.x - standing_[other].box_px.high.x;
        if (far_px <= std::max(smallest_px_, reach_px_)) return false;
        standing_[other].index.reset();
        return true;
      });
      for (const std::size_t other : open) compare_pair(standing_[k], standing_[other]);
      open.push_back(k);
    }
    const auto alone = std::count(has_near_piece_.begin(), has_near_piece_.end(), false);
    return {smallest_px_, double(alone) / double(pieces_.size())};
  }

 private:
  Vec2 a_point_px(const PieceImage& s) const {
    return pieces_[s.piece].outline_px.curves.front().front() + s.offset_px;
  }

  /// An upper bound of the smallest gap.
  float bound_px() const {
    float least_px = norm(a_point_px(standing_[0]) - a_point_px(standing_[1]));
    for (std::size_t k = 2; k < standing_.size(); ++k) {
      least_px = std::min(least_px, norm(a_point_px(standing_[k - 1]) - a_point_px(standing_[k])));
    }
    return least_px * 1.001f + 0.01f;
  }

  const PolygonIndex& index_of(PieceImage& s) const {
    if (!s.index) {
      Outline outline_px = pieces_[s.piece].outline_px;
      for (std::vector<Vec2>& curve : outline_px.curves) {
        for (Vec2& p : curve) p = p + s.offset_px;
      }
      s.index = std::make_unique<PolygonIndex>(std::move(outline_px));
    }
    return *s.index;
  }

  void compare_pair(PieceImage& a, PieceImage& b) {
    if (a.is_image && b.is_image) return;
    const bool both_accompanied = has_near_piece_[a.piece] && has_near_piece_[b.piece];
    const float look_px = both_accompanied ? smallest_px_ : std::max(smallest_px_, reach_px_);
    if (look_px <= 0 || !within_reach(a.box_px, b.box_px, look_px)) return;
    const float px = distance_px(index_of(a), index_of(b), look_px);
    smallest_px_ = std::min(smallest_px_, px);
    if (px < reach_px_) has_near_piece_[a.piece] = has_near_piece_[b.piece] = true;
  }

  const std::vector<JudgedPiece>& pieces_;
  float reach_px_;
  float smallest_px_ = 0;  // so far
  std::vector<PieceImage> standing_;
  std::vector<bool> has_near_piece_;  // another piece lies within reach
};

}  // namespace

PieceGaps piece_gaps(const std::vector<JudgedPiece>& pieces, const Period& period, float reach_px) {
  return GapSweep(pieces, period, reach_px).gaps();
}

}  // namespace tessera
