#include "core/collage/clearing.h"

#include <algorithm>

#include "core/base/stop.h"
#include "core/relax/contacts.h"
#include "core/relax/piece_neighbours.h"
#include "core/relax/schedules.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera {
namespace {

/// Passes in which a piece with a conflict moves away before it is given up. In every kPassesToMakingWay-th pass all
/// pieces around such pieces make way for them, so that the cost is shared.
constexpr int kPasses = 48;
constexpr int kPassesToMakingWay = 4;
/// Crossing limbs cannot be separated by pushing. From this pass on the smaller piece is given up, before its
/// neighbours have shrunk for nothing.
constexpr int kPassesToGivingUp = 4;
constexpr float kHopeless = 0.9f;          // of kMaxPushDepth_px, up to which depths are measured
constexpr float kLeastHopelessWay_px = 1;  // least length of a hopeless push, whatever depth is allowed
/// Factor of the scale, in each pass except those in which neighbours make way. A smaller factor would cost area, a
/// larger one more passes.
constexpr float kShrink = 0.998f;
/// Largest push of a piece out of a neighbour: it has other neighbours on its other sides.
constexpr float kMostPush_px = 0.5f;
/// Stiff, as no piece grows meanwhile: each such pass makes the remaining conflicts several times smaller.
constexpr RelaxationSchedule kMakingWay{12, 20, 20, 1, 0.3f, 0, false};
/// Least factor of the scale in each such pass. Area has no value meanwhile, so two crossing pieces would otherwise
/// shrink until they are apart.
constexpr float kLeastMakingWay = 0.99f;
/// Extra distance beyond the hard distance of relaxation, so that outlines see few remaining conflicts. Contacts beyond
/// that distance have no effect.
constexpr float kClearer_px = 0.15f;
ContactDistances rule_alone(const PieceSettings& settings) {
  const float hard_px = contact_distances(settings).hard_px + kClearer_px;
  return {hard_px, hard_px};
}

/// Largest growth beyond the size before clearing: all that the outlines allow would be mostly overlap.
constexpr float kMostRegrowth_px = 0.1f;
constexpr float kFirstRegrowth = 0.008f;  // of its size, in a step; halved after a step that fails
constexpr int kRegrowthSteps = 6;
constexpr int kPushesPerStep = 3;

class Clearing {
 public:
  Clearing(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active, const FreeField& free,
           const PieceSettings& settings)
      : pieces_(pieces),
        period_(free.grid().period()),
        reach_px_(rule_alone(settings).reach_px()),
        hopeless_px_(std::max(
            kLeastHopelessWay_px,
            kHopeless * kMaxPushDepth_px + (settings.padding_px > 0 ? settings.padding_px : -settings.overlap_px))),
        making_way_(free, rule_alone(settings)),
        outlines_(free, settings),
        laid_(pieces.size()),
        may_move_(pieces.size(), false) {
    for (const std::size_t i : active) may_move_[i] = !pieces[i].fixed;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      laid_[i].lay(*pieces[i].shape, pieces[i].canvas_from_shape);
      const ContactShape& shape = *pieces[i].shape;
      outlines_.add({ShapeId{}, pieces[i].canvas_from_shape}, shape.outline, line_radius(shape.field, shape.perimeter));
      if (may_move_[i]) maybe_conflicting_.push_back(i);
      relaxed_scale_px_.push_back(laid_[i].scale_px);
    }
  }

  std::vector<std::size_t> run(const StopCheck& check_stop) {
    for (int pass = 0; pass < kPasses; ++pass) {
      check_stop();
      const bool making_way = pass % kPassesToMakingWay == 0;
      if (making_way) make_way(check_stop);
      if (making_way && pass >= kPassesToGivingUp) give_up([this](std::size_t i) { return lies_too_deep(i); });
      std::erase_if(maybe_conflicting_, [&](std::size_t i) { return !gives_way(i, !making_way); });
      if (maybe_conflicting_.empty()) break;
    }
    give_up([this](std::size_t i) { return !conflicts_of(i).empty(); });
    grow_again(check_stop);
    std::sort(lost_.begin(), lost_.end());
    return lost_;
  }

 private:
  /// Lets each piece grow again: pieces made way for others that did so, too.
  void grow_again(const StopCheck& check_stop) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!may_move_[i]) continue;
      check_stop();
      float growth = kFirstRegrowth;
      for (int step = 0; step < kRegrowthSteps; ++step) {
        if (!grows(i, 1 + growth)) growth *= 0.5f;
      }
    }
  }

  /// Enlarges the piece by the factor and pushes it out of conflicts. If that fails, restores the pose and returns
  /// false.
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

  /// The sum of the vectors, shortened to the largest push.
  static Vec2 pushed(const std::vector<Vec2>& ways) {
    Vec2 out;
    for (const Vec2 way : ways) out = out + way;
    const float length_px = norm(out);
    return length_px > kMostPush_px ? out * (kMostPush_px / length_px) : out;
  }

  /// Pushes the piece out of its conflicts. False if it has none.
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

  /// Takes out the hopeless pieces, the smallest first, as only one of two in conflict has to go.
  template <class Hopeless>
  void give_up(Hopeless hopeless) {
    std::vector<std::size_t> smallest_first = maybe_conflicting_;
    std::stable_sort(smallest_first.begin(), smallest_first.end(),
                     [&](std::size_t a, std::size_t b) { return laid_[a].scale_px < laid_[b].scale_px; });
    for (const std::size_t i : smallest_first) {
      if (!hopeless(i)) continue;
      outlines_.take_out(i);
      may_move_[i] = false;
      lost_.push_back(i);
      std::erase(maybe_conflicting_, i);
    }
  }

  /// Whether the piece would have to move far out of another piece. Conflicts with the canvas' edge do not count:
  /// shrinking and pushing solve them.
  bool lies_too_deep(std::size_t i) const {
    const std::vector<Vec2> ways = outlines_.conflicts_with_others(i, field_distance());
    return std::any_of(ways.begin(), ways.end(), [&](Vec2 way) { return norm(way) >= hopeless_px_; });
  }

  bool is_lost(std::size_t i) const { return std::find(lost_.begin(), lost_.end(), i) != lost_.end(); }

  std::vector<Vec2> conflicts_of(std::size_t i) const { return outlines_.conflicts_of(i, field_distance()); }

  PlacedOutlines::FieldDistance field_distance() const {
    return [this](std::size_t piece, Vec2 p) { return laid_[piece].distance(p).value; };
  }

  void place(std::size_t i, const Similarity& pose) {
    pieces_[i].canvas_from_shape = period_.wrapped(pose);
    laid_[i].lay(*pieces_[i].shape, pieces_[i].canvas_from_shape);
    outlines_.move(i, pieces_[i].canvas_from_shape, pieces_[i].shape->outline);
  }

  /// Relaxes the pieces with conflicts together with their neighbours. A conflict concerns both pieces, so only pieces
  /// that moved must be checked again.
  void make_way(const StopCheck& check_stop) {
    std::erase_if(maybe_conflicting_, [&](std::size_t i) { return conflicts_of(i).empty(); });
    const std::vector<std::size_t> movable = with_neighbours(maybe_conflicting_);
    std::vector<RelaxedPiece> standing;
    std::vector<std::size_t> active;  // indices in `standing` of the movable pieces, in their order
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (std::binary_search(movable.begin(), movable.end(), i)) active.push_back(standing.size());
      if (is_lost(i)) continue;
      standing.push_back(pieces_[i]);
      float& least_px = standing.back().poses.min_scale_px;
      least_px = std::max(least_px, kLeastMakingWay * laid_[i].scale_px);
    }
    making_way_.relax(standing, active, kMakingWay, check_stop);
    std::vector<std::size_t> unsure;
    for (std::size_t k = 0; k < movable.size(); ++k) {
      const std::size_t i = movable[k];
      const Similarity& now = standing[active[k]].canvas_from_shape;
      const bool was_unsure = std::binary_search(maybe_conflicting_.begin(), maybe_conflicting_.end(), i);
      const bool moved = now != pieces_[i].canvas_from_shape;
      if (moved) place(i, now);
      if (moved || was_unsure) unsure.push_back(i);
    }
    maybe_conflicting_ = std::move(unsure);
  }

  /// These pieces and all movable pieces in contact with them; ascending.
  std::vector<std::size_t> with_neighbours(const std::vector<std::size_t>& some) const {
    std::vector<Box> boxes;
    for (const ContactPiece& piece : laid_) boxes.push_back(piece.box);
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
  float hopeless_px_;  // length of a push that counts as hopeless
  Relaxation making_way_;
  PlacedOutlines outlines_;
  std::vector<ContactPiece> laid_;
  std::vector<float> relaxed_scale_px_;
  std::vector<bool> may_move_;
  std::vector<std::size_t> maybe_conflicting_;  // ascending: pieces that may have a conflict
  std::vector<std::size_t> lost_;               // in the order in which they were given up
};

}  // namespace

std::vector<std::size_t> make_clear(std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active,
                                    const FreeField& free, const PieceSettings& settings, const StopCheck& check_stop) {
  return Clearing(pieces, active, free, settings).run(check_stop);
}

}  // namespace tessera
