#include "products/puzzle/laying/frame_covering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/stop.h"

namespace tessera {
namespace {

/// Upper bound of pieces laid, including those taken back: some 2 ms each.
constexpr int kMostLaid = 4'000;
/// Steps in which a piece settles beside laid ones.
constexpr int kCoveringSteps = 3;
/// Distance from a corner at which it is tested whether something lies there, in steps along the side and away from it:
/// less than the narrowest corner of a piece, more than the outlines' errors.
constexpr std::size_t kAlong = 8;
constexpr float kAway = 2;
/// Cosines and sines of directions from a corner, 30 to 165 degrees from its side: a free corner that is narrower than a
/// straight line meets something in one of these. Written out, because they must be the same on all machines.
constexpr std::array<Vec2, 6> kTurned = {
    {{0.866025f, 0.5f}, {0.5f, 0.866025f}, {0, 1}, {-0.5f, 0.866025f}, {-0.866025f, 0.5f}, {-0.965926f, 0.258819f}}};

/// A corner of a laid piece, and the pieces that may lie along its side ahead.
struct OpenCorner {
  std::size_t owner = 0;   // index in laid
  std::size_t corner = 0;  // corner of that piece
  std::vector<PosedPiece> candidates = {};
};

struct State {
  std::vector<PosedPiece> laid;  // the frame first
  std::vector<OpenCorner> corners;
};

class Search {
 public:
  Search(const std::vector<PuzzlePiece>& pieces, const std::vector<std::vector<PieceMatch>>& matches,
         const PuzzleScale& scale, const StopCheck& check_stop)
      : pieces_(pieces),
        matches_(matches),
        scale_(scale),
        check_stop_(check_stop) {}

  std::optional<std::vector<Similarity>> poses() {
    State state;
    lay({&pieces_.back(), {}}, state);
    if (!filled(state)) return {};
    std::vector<Similarity> poses(pieces_.size() - 1);
    for (std::size_t k = 1; k < result_.size(); ++k) poses[number(result_[k])] = result_[k].pose;
    return poses;
  }

 private:
  std::size_t number(const PosedPiece& piece) const { return std::size_t(piece.piece - pieces_.data()); }

  bool filled(const State& state) {
    if (state.laid.size() == pieces_.size()) {
      result_ = state.laid;
      return true;
    }
    std::vector<PosedPiece> tried;
    for (const PosedPiece& candidate : narrowest(state)) {
      if (laid_ >= kMostLaid) return false;
      const auto alike = [&](const PosedPiece& other) { return cover_the_same(candidate, other); };
      if (std::any_of(tried.begin(), tried.end(), alike)) continue;
      tried.push_back(candidate);
      State next = state;
      const std::vector<PosedPiece> around = near(candidate, state);
      lay({candidate.piece, settled(candidate, around, scale_, kCoveringSteps)}, next);
      if (filled(next)) return true;
    }
    return false;
  }

  /// The candidates of the corner with the fewest, among corners that one of them must fill.
  std::vector<PosedPiece> narrowest(const State& state) const {
    const OpenCorner* best = nullptr;
    for (const OpenCorner& corner : state.corners) {
      if (best && corner.candidates.size() >= best->candidates.size()) continue;
      if (is_narrow(corner, state)) best = &corner;
    }
    return best ? best->candidates : std::vector<PosedPiece>{};
  }

  /// A point beside the corner's side that the filling piece covers; `turned` away from its outward direction.
  static Vec2 beside(const PosedPiece& owner, const PuzzleCorner& corner, Vec2 turned) {
    const Vec2 along = corner.ahead[kAlong] - corner.ahead.front();
    const Vec2 outside{along.y, -along.x};
    return owner.pose.apply(corner.ahead.front() + along * turned.x + outside * turned.y);
  }

  static bool is_covered(Vec2 p, const State& state) {
    return std::any_of(state.laid.begin(), state.laid.end(), [&](const PosedPiece& laid) { return covers(laid, p); });
  }

  bool is_free(const OpenCorner& corner, const State& state) const {
    const PosedPiece& owner = state.laid[corner.owner];
    return !is_covered(beside(owner, owner.piece->corners[corner.corner], {1, kAway / float(kAlong)}), state);
  }

  bool is_narrow(const OpenCorner& corner, const State& state) const {
    const PosedPiece& owner = state.laid[corner.owner];
    return std::any_of(kTurned.begin(), kTurned.end(), [&](Vec2 turned) {
      return is_covered(beside(owner, owner.piece->corners[corner.corner], turned), state);
    });
  }

  /// Whether both cover the same area, like two congruent pieces, or one piece turned by its own symmetry.
  bool cover_the_same(const PosedPiece& a, const PosedPiece& b) const {
    if (norm(a.pose.apply(a.piece->centre) - b.pose.apply(b.piece->centre)) > 2 * scale_.tolerance) return false;
    if (std::abs(a.piece->area / b.piece->area - 1) > 0.1) return false;
    const Similarity b_from_a = followed_by(a.pose, rigid_inverse(b.pose));
    return std::all_of(a.piece->points.begin(), a.piece->points.end(),
                       [&](Vec2 p) { return b.piece->outline.nearer_than(3 * scale_.tolerance, b_from_a.apply(p)); });
  }

  std::vector<PosedPiece> near(const PosedPiece& piece, const State& state) const {
    std::vector<PosedPiece> all;
    for (const PosedPiece& laid : state.laid) {
      if (may_touch(piece, laid, 4 * scale_.tolerance)) all.push_back(laid);
    }
    return all;
  }

  void lay(const PosedPiece& piece, State& state) {
    ++laid_;
    check_stop_();
    state.laid.push_back(piece);
    for (OpenCorner& corner : state.corners) {
      std::erase_if(corner.candidates, [&](const PosedPiece& candidate) {
        return candidate.piece == piece.piece || overlap(candidate, piece, scale_);
      });
    }
    for (std::size_t k = 0; k < piece.piece->corners.size(); ++k) {
      if (piece.piece->corners[k].ahead.size() > kAlong) state.corners.push_back({state.laid.size() - 1, k});
    }
    std::erase_if(state.corners, [&](const OpenCorner& corner) { return !is_free(corner, state); });
    for (OpenCorner& corner : state.corners) {
      if (corner.owner + 1 == state.laid.size()) find_candidates(corner, state);
    }
  }

  void find_candidates(OpenCorner& corner, const State& state) const {
    const PosedPiece& owner = state.laid[corner.owner];
    for (const PieceMatch& match : matches_[number(owner)]) {
      const PuzzlePiece& other = pieces_[std::size_t(match.piece)];
      if (match.corner_ahead != int(corner.corner) || other.area < 0) continue;
      const PosedPiece candidate{&other, followed_by(match.here_from_there, owner.pose)};
      const bool fits = std::none_of(state.laid.begin(), state.laid.end(), [&](const PosedPiece& laid) {
        return laid.piece == &other || overlap(candidate, laid, scale_);
      });
      if (fits) corner.candidates.push_back(candidate);
    }
  }

  const std::vector<PuzzlePiece>& pieces_;
  const std::vector<std::vector<PieceMatch>>& matches_;
  const PuzzleScale& scale_;
  const StopCheck& check_stop_;
  int laid_ = 0;
  std::vector<PosedPiece> result_;
};

}  // namespace

std::optional<std::vector<Similarity>> frame_covering(const std::vector<PuzzlePiece>& pieces,
                                                      const std::vector<std::vector<PieceMatch>>& matches,
                                                      const PuzzleScale& scale, const StopCheck& check_stop) {
  if (pieces.size() > kMostCoveringPieces + 1) return {};
  return Search(pieces, matches, scale, check_stop).poses();
}

}  // namespace tessera
