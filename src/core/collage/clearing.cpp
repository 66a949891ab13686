#include "core/collage/clearing.h"

#include <algorithm>

#include "core/relax/contacts.h"
#include "core/relax/piece_neighbours.h"
#include "core/relax/schedules.h"

namespace tessera {
namespace {

/// A piece that conflicts gives way so often before it is given up; now and then all that stand round such pieces make
/// way for them, so that not one of them pays for all.
constexpr int kPasses = 48;
constexpr int kPassesToMakingWay = 8;
/// Of the scale, in each pass but those after making way. Smaller costs passes, larger costs area.
constexpr float kShrink = 0.995f;
/// Of a piece out of a neighbour: it has others on its other sides.
constexpr float kMostPush_px = 0.5f;
/// Stiff, as nothing grows meanwhile; a conflict that is left is about so many times smaller than that before.
constexpr RelaxationSchedule kMakingWay{12, 20, 20, 1, 0.3f, 0, false};
/// Farther apart than what is hard while pieces grow, so that few are left between which outlines still see a conflict;
/// nobody feels more than that.
constexpr float kClearer_px = 0.15f;
ContactDistances rule_alone(const PieceSettings& settings) {
  const float hard_px = contact_distances(settings).hard_px + kClearer_px;
  return {hard_px, hard_px};
}

/// Afterwards so much larger than before all this: all that the outlines allow would be mostly overlap.
constexpr float kMostRegrowth_px = 0.1f;
constexpr float kFirstRegrowth = 0.008f;  // of its size, in a step; half of it where that does not go
constexpr int kRegrowthSteps = 6;
constexpr int kPushesPerStep = 3;

class Clearing {
 public:
  Clearing(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active, const FreeField& free,
           const PieceSettings& settings)
      : pieces_(pieces),
        period_(free.grid().period()),
        reach_px_(rule_alone(settings).reach_px()),
        making_way_(free, rule_alone(settings)),
        outlines_(free, settings),
        laid_(pieces.size()),
        may_move_(pieces.size(), false) {
    for (const std::size_t i : active) may_move_[i] = !pieces[i].fixed;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      laid_[i].lay(*pieces[i].shape, pieces[i].canvas_from_shape);
      outlines_.add({ShapeId{}, pieces[i].canvas_from_shape}, pieces[i].shape->outline);
      if (may_move_[i]) unsure_.push_back(i);
      relaxed_scale_px_.push_back(laid_[i].scale_px);
    }
  }

  std::vector<std::size_t> run(const std::function<void()>& look) {
    for (int pass = 0; pass < kPasses; ++pass) {
      look();
      if (pass % kPassesToMakingWay == 0) make_way(look);
      const bool shrinking = pass % kPassesToMakingWay > 0;
      std::erase_if(unsure_, [&](std::size_t i) { return !gives_way(i, shrinking); });
      if (unsure_.empty()) break;
    }
    const std::vector<std::size_t> lost = give_up();
    grow_again(lost, look);
    return lost;
  }

 private:
  /// Pieces made way for others that did so, too.
  void grow_again(const std::vector<std::size_t>& lost, const std::function<void()>& look) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!may_move_[i] || std::binary_search(lost.begin(), lost.end(), i)) continue;
      look();
      float growth = kFirstRegrowth;
      for (int step = 0; step < kRegrowthSteps; ++step) {
        if (!grows(i, 1 + growth)) growth *= 0.5f;
      }
    }
  }

  /// Moving out of the way of others where need be; as it was where it cannot.
  bool grows(std::size_t i, float factor) {
    const Similarity before = pieces_[i].canvas_from_shape;
    Similarity pose = before;
    pose.a *= factor;
    pose.b *= factor;
    pieces_[i].poses.pull_in(pose);
    if (pose.scale() <= before.scale() || pose.scale() > relaxed_scale_px_[i] + kMostRegrowth_px) return false;
    for (int push = 0; push < kPushesPerStep; ++push) {
      place(i, pose);
      const std::vector<Vec2> ways = conflicts_of(i);
      if (ways.empty()) return true;
      pose = moved(pieces_[i].canvas_from_shape, pushed(ways));
    }
    place(i, before);
    return false;
  }

  /// Their sum, or as much of it as a piece is moved at once.
  static Vec2 pushed(const std::vector<Vec2>& ways) {
    Vec2 out;
    for (const Vec2 way : ways) out = out + way;
    const float length_px = norm(out);
    return length_px > kMostPush_px ? out * (kMostPush_px / length_px) : out;
  }

  /// False where it has no conflict.
  bool gives_way(std::size_t i, bool shrinking) {
    const std::vector<Vec2> ways = conflicts_of(i);
    if (ways.empty()) return false;
    Similarity pose = pieces_[i].canvas_from_shape;
    pose = moved(pose, pushed(ways));
    if (shrinking) {
      pose.a *= kShrink;
      pose.b *= kShrink;
      pieces_[i].poses.pull_in(pose);
    }
    place(i, pose);
    return true;
  }

  /// The smallest first, as of two pieces only one need go.
  std::vector<std::size_t> give_up() {
    std::stable_sort(unsure_.begin(), unsure_.end(),
                     [&](std::size_t a, std::size_t b) { return laid_[a].scale_px < laid_[b].scale_px; });
    std::vector<std::size_t> given_up;
    for (const std::size_t i : unsure_) {
      if (conflicts_of(i).empty()) continue;
      outlines_.take_out(i);
      given_up.push_back(i);
    }
    std::sort(given_up.begin(), given_up.end());
    return given_up;
  }

  std::vector<Vec2> conflicts_of(std::size_t i) const {
    return outlines_.conflicts_of(i, [this](std::size_t piece, Vec2 p) { return laid_[piece].distance(p).value; });
  }

  void place(std::size_t i, const Similarity& pose) {
    pieces_[i].canvas_from_shape = period_.wrapped(pose);
    laid_[i].lay(*pieces_[i].shape, pieces_[i].canvas_from_shape);
    outlines_.move(i, pieces_[i].canvas_from_shape, pieces_[i].shape->outline);
  }

  /// A conflict is one of both pieces, so that only those that moved need be looked at again.
  void make_way(const std::function<void()>& look) {
    std::erase_if(unsure_, [&](std::size_t i) { return conflicts_of(i).empty(); });
    const std::vector<std::size_t> movable = with_neighbours(unsure_);
    std::vector<RelaxedPiece> before = pieces_;
    making_way_.relax(pieces_, movable, kMakingWay, look);
    std::vector<std::size_t> unsure;
    for (const std::size_t i : movable) {
      const bool was_unsure = std::binary_search(unsure_.begin(), unsure_.end(), i);
      const bool moved = pieces_[i].canvas_from_shape != before[i].canvas_from_shape;
      if (moved) place(i, pieces_[i].canvas_from_shape);
      if (moved || was_unsure) unsure.push_back(i);
    }
    unsure_ = std::move(unsure);
  }

  /// Those, and all that feel them and may move; ascending.
  std::vector<std::size_t> with_neighbours(const std::vector<std::size_t>& some) const {
    std::vector<Box> boxes;
    for (const LaidPiece& piece : laid_) boxes.push_back(piece.box);
    const PieceNeighbours near(boxes, period_);
    std::vector<std::size_t> all = some;
    for (const std::size_t i : some) {
      for (const Neighbour& n : near.of(std::uint32_t(i), reach_px_)) {
        if (may_move_[n.piece]) all.push_back(n.piece);
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  std::vector<RelaxedPiece>& pieces_;
  Period period_;
  float reach_px_;
  Relaxation making_way_;
  PlacedOutlines outlines_;
  std::vector<LaidPiece> laid_;
  std::vector<float> relaxed_scale_px_;
  std::vector<bool> may_move_;
  std::vector<std::size_t> unsure_;  // ascending: who may have a conflict
};

}  // namespace

std::vector<std::size_t> make_clear(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active,
                                    const FreeField& free, const PieceSettings& settings,
                                    const std::function<void()>& look) {
  return Clearing(pieces, active, free, settings).run(look);
}

}  // namespace tessera
