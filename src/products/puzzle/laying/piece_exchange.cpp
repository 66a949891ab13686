#include "products/puzzle/laying/piece_exchange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/base/stop.h"

namespace tessera {
namespace {

/// The largest relative differences of areas and radii of pieces with one outline.
constexpr double kSameSize = 0.05;
/// The largest difference of outlines of one shape, in tolerances; it comes from tracing.
constexpr float kSameOutline = 3;
/// Agreement (-1 to 1) for each point of the cuts; below it another place is as good. A right puzzle has 0.2 and more
/// (chelsea.png in 20 rectangles); wrongly laid pieces have less than 0.08.
constexpr float kAsGood = 0.1f;
/// Mean agreement along a side: below the first another order is searched, below the second the pieces are unrelated. The
/// least of right pieces was 0.07 (same puzzle).
constexpr float kPoorSide = 0.1f;
constexpr float kStrangers = -0.3f;
/// Least number of points of a side, as a part of a piece's points: pieces that meet at a corner share fewer.
constexpr float kLeastSide = 0.1f;
/// Each way to fill a place takes 2 KB; this is enough for some 300 rectangles.
constexpr std::size_t kMostWays = 200'000;
/// The most beginnings from which the places are filled anew where exchanges leave a doubt. The time of one filling grows
/// with the square of the pieces, so more pieces get fewer beginnings.
constexpr int kBeginningsOfFew = 600;
constexpr int kBeginningsBySquare = 300'000;
/// Exchanges improve a filling by some tenths and take most of the time: only fillings with this part of the best agreement
/// get them.
constexpr float kWorthExchanging = 0.8f;

bool is_turned_alike(const Similarity& a, const Similarity& b) { return a.a * b.a + a.b * b.b > 0.99f; }

using Colours = std::vector<std::optional<PiecePicture::Colour>>;  // at the ends of a slot

/// A way in which a piece fills a slot.
struct Way {
  Similarity pose;
  Colours colours;
};

/// A place that one piece or another may fill.
struct Slot {
  PosedPiece first;                              // the piece that was there first: the place's outline
  std::vector<int> ends = {};                    // of contacts: twice the contact's number, plus 1 on its second side
  std::map<int, std::vector<Way>> fitting = {};  // by piece
};

/// A point of the cut between two slots, and points a little inside each of them.
struct Contact {
  int slots[2] = {};
  Vec2 inside[2] = {};
};

/// The piece in a slot, and its way.
struct Filling {
  int piece = 0;
  const Way* way = nullptr;
};

struct Change {
  float gain = 0;
  Filling a, b;  // no way: there is none
};

class Exchange {
 public:
  Exchange(const std::vector<PosedPiece>& laid, const PuzzleScale& scale) : scale_(scale) {
    for (const PosedPiece& piece : laid) slots_.push_back({piece});
    for (int a = 0; a < count(); ++a) {
      for (int b = a + 1; b < count(); ++b) add_contacts(a, b);
    }
    for (int s = 0; s < count(); ++s) add_ways(s);
    for (int s = 0; s < count(); ++s) fillings_.push_back({s, &slot(s).fitting.at(s).front()});
  }

  bool is_feasible() const { return ways_ <= kMostWays; }

  /// Makes exchanges and turns as long as they make the whole agree better.
  void improve(const StopCheck& check_stop) {
    constexpr float kLeastGain = 1e-3f;  // more than sums are rounded by
    for (bool better = true; better;) {
      better = false;
      for (int a = 0; a < count(); ++a) {
        check_stop();
        for (const int b : alike_from(a)) {
          const Change change = best_change(a, b);
          if (!change.a.way || change.gain < kLeastGain) continue;
          apply(a, b, change);
          better = true;
        }
      }
    }
  }

  /// Fills all slots anew from many beginnings and keeps the best filling. A beginning is one piece in one slot; then the
  /// slot and the piece are filled that agree best with the laid ones. Exchanges alone cannot move a group of pieces that
  /// fit each other.
  void grow(const StopCheck& check_stop) {
    std::vector<Filling> best = fillings_;
    float most = agreement();
    const std::vector<Beginning> all = beginnings();
    const std::size_t step = all.size() / std::size_t(most_beginnings()) + 1;
    for (std::size_t k = 0; k < all.size(); k += step) {
      check_stop();
      if (!fill_from(all[k]) || agreement() < kWorthExchanging * most) continue;
      improve(check_stop);
      if (const float now = agreement(); now > most) {
        most = now;
        best = fillings_;
      }
    }
    fillings_ = best;
  }

  bool has_poor_side() const { return count_of(beside_sides_below(kPoorSide)) > 0; }

  /// The number of pieces that agree about as well after a change, or lie beside unrelated ones.
  int undecided(const StopCheck& check_stop) const {
    std::vector<bool> open = beside_sides_below(kStrangers);
    for (int a = 0; a < count(); ++a) {
      check_stop();
      for (const int b : alike_from(a)) {
        const Change change = best_change(a, b);
        const float points = float(slot(a).ends.size() + (a == b ? 0 : slot(b).ends.size()));
        if (change.a.way && change.gain > -kAsGood * points) open[std::size_t(a)] = open[std::size_t(b)] = true;
      }
    }
    return count_of(open);
  }

  std::vector<Similarity> poses() const {
    std::vector<Similarity> poses(slots_.size());
    for (const Filling& filling : fillings_) poses[std::size_t(filling.piece)] = filling.way->pose;
    return poses;
  }

 private:
  int count() const { return int(slots_.size()); }
  Slot& slot(int s) { return slots_[std::size_t(s)]; }
  const Slot& slot(int s) const { return slots_[std::size_t(s)]; }
  const Filling& filling(int s) const { return fillings_[std::size_t(s)]; }
  const Contact& contact(int end) const { return contacts_[std::size_t(end / 2)]; }

  void add_contacts(int a, int b) {
    const PosedPiece &here = slot(a).first, &there = slot(b).first;
    if (!may_touch(here, there, scale_.tolerance)) return;
    const Similarity there_from_here = followed_by(here.pose, rigid_inverse(there.pose));
    for (std::size_t k = 0; k < here.piece->points.size(); ++k) {
      const Vec2 point = there_from_here.apply(here.piece->points[k]);
      const Approach near = there.piece->outline.approach(point, scale_.tolerance);
      if (near.distance >= scale_.tolerance) continue;
      const Vec2 along = here.pose.apply_direction(here.piece->directions[k]);
      const Vec2 inwards = Vec2{-along.y, along.x} * inside_from_edge(scale_);
      slot(a).ends.push_back(2 * int(contacts_.size()));
      slot(b).ends.push_back(2 * int(contacts_.size()) + 1);
      contacts_.push_back(
          {{a, b}, {here.pose.apply(here.piece->points[k]) + inwards, there.pose.apply(near.there) - inwards}});
    }
  }

  /// Adds the ways of all pieces. A piece's own pose comes first in its own slot.
  void add_ways(int s) {
    for (int piece = 0; piece < count() && ways_ <= kMostWays; ++piece) {
      std::vector<Similarity> poses;
      if (piece == s) poses.push_back(slot(s).first.pose);
      add_fitting_poses(s, piece, poses);
      for (const Similarity& pose : poses) slot(s).fitting[piece].push_back({pose, colours_of(s, piece, pose)});
      ways_ += poses.size();
    }
    if (slot(s).fitting.contains(s)) return;
    slot(s).fitting[s].push_back({slot(s).first.pose, {}});
  }

  /// Adds poses in which the outlines lie on each other, corner on corner.
  void add_fitting_poses(int s, int piece, std::vector<Similarity>& poses) const {
    const PuzzlePiece &p = *slot(piece).first.piece, &q = *slot(s).first.piece;
    if (p.corners.empty() || std::abs(p.area / q.area - 1) > kSameSize ||
        std::abs(double(p.radius / q.radius) - 1) > kSameSize)
      return;
    const Vec2 arm = p.corners.front().ahead.front() - p.centre;
    for (const PuzzleCorner& corner : q.corners) {
      const std::optional<Similarity> turn = turning(arm, corner.ahead.front() - q.centre);
      if (!turn) continue;
      const Vec2 shift = q.centre - turn->apply(p.centre);
      const Similarity q_from_p{turn->a, turn->b, shift.x, shift.y};
      const Similarity pose = followed_by(q_from_p, slot(s).first.pose);
      const auto is_it = [&](const Similarity& other) { return is_turned_alike(other, pose); };
      if (std::none_of(poses.begin(), poses.end(), is_it) && lies_on(p, q, q_from_p)) poses.push_back(pose);
    }
  }

  /// The rotation from one direction to the other; empty where their lengths differ.
  std::optional<Similarity> turning(Vec2 from, Vec2 to) const {
    if (std::abs(norm(from) - norm(to)) > kSameOutline * scale_.tolerance) return std::nullopt;
    const Vec2 turn{dot(from, to), cross(from, to)};
    const float length = norm(turn);
    if (length <= 0) return std::nullopt;
    return Similarity{turn.x / length, turn.y / length, 0, 0};
  }

  bool lies_on(const PuzzlePiece& p, const PuzzlePiece& q, const Similarity& q_from_p) const {
    return std::all_of(p.points.begin(), p.points.end(), [&](Vec2 point) {
      return q.outline.nearer_than(kSameOutline * scale_.tolerance, q_from_p.apply(point));
    });
  }

  static int count_of(const std::vector<bool>& slots) { return int(std::count(slots.begin(), slots.end(), true)); }

  /// Marks slots whose pieces may lie elsewhere and that have a side with less agreement than `least`.
  std::vector<bool> beside_sides_below(float least) const {
    struct Side {
      float agreement = 0;
      int points = 0;
    };
    std::map<std::pair<int, int>, Side> sides;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto [a, b] = contacts_[k].slots;
      const auto& here = filling(a).way->colours[place_of_end(a, 2 * int(k))];
      const auto& there = filling(b).way->colours[place_of_end(b, 2 * int(k) + 1)];
      if (!here || !there) continue;
      Side& side = sides[{a, b}];
      side.agreement += agreement_between(*here, *there);
      ++side.points;
    }
    std::vector<bool> below(slots_.size(), false);
    for (const auto& [slots, side] : sides) {
      const float points = float(slot(slots.first).first.piece->points.size());
      if (float(side.points) < kLeastSide * points || side.agreement >= least * float(side.points)) continue;
      for (const int s : {slots.first, slots.second}) below[std::size_t(s)] = has_other_ways(s);
    }
    return below;
  }

  bool has_other_ways(int s) const { return slot(s).fitting.size() > 1 || slot(s).fitting.begin()->second.size() > 1; }

  float agreement_between(const PiecePicture::Colour& a, const PiecePicture::Colour& b) const {
    return 1 - 2 * std::min(1.f, colour_distance(a, b) / scale_.contrast);
  }

  Colours colours_of(int s, int piece, const Similarity& pose) const {
    const PiecePicture* picture = slot(piece).first.piece->picture;
    const Similarity piece_from_puzzle = rigid_inverse(pose);
    Colours colours;
    for (const int end : slot(s).ends) {
      const Vec2 p = piece_from_puzzle.apply(contact(end).inside[end % 2]);
      colours.push_back(picture ? picture->at(p) : std::nullopt);
    }
    return colours;
  }

  /// The slots from `a` on that may exchange their pieces with it.
  std::vector<int> alike_from(int a) const {
    std::vector<int> alike;
    for (int b = a; b < count(); ++b) {
      if (slot(a).fitting.contains(filling(b).piece)) alike.push_back(b);
    }
    return alike;
  }

  /// The agreement of the contacts of slot `s`, if it has the way `in_s` and `other` has `in_other`. `with_between`:
  /// contacts between the two slots count.
  float agreement_at(int s, const Way& in_s, int other, const Way& in_other, bool with_between) const {
    const std::vector<int>& ends = slot(s).ends;
    float sum = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const int across = contact(ends[k]).slots[1 - ends[k] % 2];
      if (across == other && !with_between) continue;
      const Way& there = across == other ? in_other : *filling(across).way;
      const auto &colour = in_s.colours[k], &beyond = there.colours[place_of_end(across, ends[k] ^ 1)];
      if (colour && beyond) sum += agreement_between(*colour, *beyond);
    }
    return sum;
  }

  std::size_t place_of_end(int s, int end) const {
    const std::vector<int>& ends = slot(s).ends;  // in rising order
    return std::size_t(std::lower_bound(ends.begin(), ends.end(), end) - ends.begin());
  }

  float agreement_of(int a, const Way& in_a, int b, const Way& in_b) const {
    return agreement_at(a, in_a, b, in_b, true) + (a == b ? 0 : agreement_at(b, in_b, a, in_a, false));
  }

  /// The agreement of all slots; every contact counts twice.
  float agreement() const {
    float sum = 0;
    for (int s = 0; s < count(); ++s) sum += agreement_at(s, *filling(s).way, s, *filling(s).way, true);
    return sum;
  }

  /// The best change of the pieces in a and b; with a == b the piece is turned.
  Change best_change(int a, int b) const {
    const auto for_a = slot(a).fitting.find(filling(b).piece), for_b = slot(b).fitting.find(filling(a).piece);
    if (for_a == slot(a).fitting.end() || for_b == slot(b).fitting.end()) return {};
    const float now = agreement_of(a, *filling(a).way, b, *filling(b).way);
    Change best;
    const auto offer = [&](const Way& in_a, const Way& in_b) {
      const float gain = agreement_of(a, in_a, b, in_b) - now;
      if (!best.a.way || gain > best.gain) best = {gain, {filling(b).piece, &in_a}, {filling(a).piece, &in_b}};
    };
    for (const Way& in_a : for_a->second) {
      if (a != b) {
        for (const Way& in_b : for_b->second) offer(in_a, in_b);
      } else if (&in_a != filling(a).way) {
        offer(in_a, in_a);
      }
    }
    return best;
  }

  void apply(int a, int b, const Change& change) {
    fillings_[std::size_t(a)] = change.a;
    fillings_[std::size_t(b)] = change.b;
  }

  struct Beginning {
    int slot = 0;
    Filling filling;
  };

  std::vector<Beginning> beginnings() const {
    std::vector<Beginning> all;
    for (int s = 0; s < count(); ++s) {
      for (const auto& [piece, ways] : slot(s).fitting) {
        for (const Way& way : ways) all.push_back({s, {piece, &way}});
      }
    }
    return all;
  }

  int most_beginnings() const { return std::clamp(kBeginningsBySquare / (count() * count()), 1, kBeginningsOfFew); }

  /// An offer: the piece that fills a slot best, beside the laid pieces.
  struct Offer {
    Filling filling = {-1, nullptr};
    float agreement = -1e9f;
  };

  /// Fills all slots. False: there is no piece for a slot.
  bool fill_from(const Beginning& beginning) {
    fillings_.assign(slots_.size(), Filling{-1, nullptr});
    std::vector<bool> used(slots_.size(), false);
    std::vector<Offer> offers(slots_.size());
    const auto put = [&](int s, const Filling& filling) {
      fillings_[std::size_t(s)] = filling;
      used[std::size_t(filling.piece)] = true;
    };
    put(beginning.slot, beginning.filling);
    int last = beginning.slot;
    for (int filled = 1; filled < count(); ++filled) {
      int next = -1;
      for (int s = 0; s < count(); ++s) {
        if (filling(s).way) continue;
        Offer& offer = offers[std::size_t(s)];
        const bool stale = !offer.filling.way || used[std::size_t(offer.filling.piece)] || touches(s, last);
        if (stale) offer = best_offer(s, used);
        if (offer.filling.way && (next < 0 || offer.agreement > offers[std::size_t(next)].agreement)) next = s;
      }
      if (next < 0) return false;
      put(next, offers[std::size_t(next)].filling);
      last = next;
    }
    return true;
  }

  bool touches(int s, int other) const {
    return std::any_of(slot(s).ends.begin(), slot(s).ends.end(),
                       [&](int end) { return contact(end).slots[1 - end % 2] == other; });
  }

  Offer best_offer(int s, const std::vector<bool>& used) const {
    Offer best;
    for (const auto& [piece, ways] : slot(s).fitting) {
      if (used[std::size_t(piece)]) continue;
      for (const Way& way : ways) {
        const float agreement = agreement_with_filled(s, way);
        if (agreement > best.agreement) best = {{piece, &way}, agreement};
      }
    }
    return best;
  }

  float agreement_with_filled(int s, const Way& way) const {
    const std::vector<int>& ends = slot(s).ends;
    float sum = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const int across = contact(ends[k]).slots[1 - ends[k] % 2];
      if (!filling(across).way) continue;
      const auto &colour = way.colours[k], &beyond = filling(across).way->colours[place_of_end(across, ends[k] ^ 1)];
      if (colour && beyond) sum += agreement_between(*colour, *beyond);
    }
    return sum;
  }

  const PuzzleScale scale_;
  std::vector<Slot> slots_;
  std::vector<Contact> contacts_;
  std::vector<Filling> fillings_;  // of the slots
  std::size_t ways_ = 0;
};

}  // namespace

ExchangedPieces exchanged(const std::vector<PosedPiece>& laid, const PuzzleScale& scale, const StopCheck& check_stop) {
  ExchangedPieces all;
  for (const PosedPiece& piece : laid) all.poses.push_back(piece.pose);
  if (scale.contrast <= 0) return all;
  Exchange exchange(laid, scale);
  all.undecided = int(laid.size());
  if (!exchange.is_feasible()) return all;
  exchange.improve(check_stop);
  all.undecided = exchange.undecided(check_stop);
  if (all.undecided > 0 || exchange.has_poor_side()) {
    exchange.grow(check_stop);
    all.undecided = exchange.undecided(check_stop);
  }
  all.poses = exchange.poses();
  return all;
}

}  // namespace tessera
