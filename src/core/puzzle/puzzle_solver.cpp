#include "core/puzzle/puzzle_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/geometry/polygon.h"
#include "core/puzzle/frame_covering.h"
#include "core/puzzle/piece_exchange.h"
#include "core/puzzle/piece_matches.h"
#include "core/puzzle/poses_in_frame.h"
#include "core/puzzle/puzzle_contact.h"
#include "core/puzzle/puzzle_piece.h"

namespace tessera {
namespace {

/// What a boundary beside a gap costs, in parts of what one in contact is worth.
constexpr float kGapCost = 1;
/// What a boundary in contact is worth more where the pictures agree, and less where they do not: a bend's is 1, a
/// straight line's 0.3.
constexpr float kOfPictures = 0.5f;
/// Of what is laid in one place: the best and so many others.
constexpr std::size_t kMostBranches = 4;
/// A place's contact is worth so much, by the neighbours with which it shares a side from corner to corner: one comes
/// about by chance, two hardly.
constexpr std::array<float, 4> kOfSides = {0.5f, 1, 2, 3};
/// Beginnings without a frame, where most of the pieces do not go together.
constexpr int kMostIslands = 4;
/// Pieces that may lie in a corner of the frame.
constexpr std::size_t kMostBeginnings = 16;
/// Arrangements times pieces: more than 250 pieces are laid by greed alone.
constexpr int kMostFollowed = 2'000;
/// Coherence is nothing where a tenth of the boundaries is beside narrow gaps.
constexpr double kGapsAgainst = 10;
/// What a place must be worth, in sides of a piece: so much agrees by chance. Or, for small pieces, in parts of what
/// the place would be worth where all of the boundary touched.
constexpr float kLeastWorth = 0.3f;
constexpr float kLeastPart = 0.5f;
/// Part of a piece's boundary, as it counts, that touches others in the end.
constexpr float kLeastTouching = 0.2f;
/// Of an arrangement, the best; a puzzle of 400 pieces has some hundreds, drawings that are none may have any number.
constexpr std::size_t kMostPlaces = 4'000;
/// Steps in which a piece comes to rest when it is laid, and rounds in which all do in the end.
constexpr int kSettlingSteps = 3;
constexpr int kLastRounds = 20;

/// A place that a piece may have, in one arrangement.
struct Place {
  int piece = 0;
  Similarity pose = {};
  std::vector<Beside> beside = {};  // of each point of its boundary
  float pictures = 0;               // how well they agree, a sum over those points that touch
  float worth = 0;
  int whole_sides = 0;  // neighbours with which it shares one from corner to corner
};

struct Laid {
  int piece = 0;
  Similarity pose;
};

struct Arrangement {
  std::vector<Laid> laid;  // the frame first, if any
  std::vector<bool> used;
  std::vector<Place> places;
  double worth = 0;
  bool frame_is_open = false;  // pieces are looked for along the frame, too
};

/// Mean distance of the pictures' colours between places of different pieces, along their boundaries; 0 without
/// pictures, and of plain ones.
float contrast_of(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale) {
  constexpr std::size_t kPlaces = 16;  // of each piece
  constexpr float kPlain = 4;          // levels of 255
  std::vector<PiecePicture::Colour> colours;
  for (const PuzzlePiece& piece : pieces) {
    for (std::size_t k = 0; piece.picture && k < kPlaces; ++k) {
      const std::size_t at = k * piece.points.size() / kPlaces;
      const Vec2 along = piece.directions[at], outside{along.y, -along.x};
      if (const auto colour = piece.picture->at(piece.points[at] - outside * (2 * scale.step)))
        colours.push_back(*colour);
    }
  }
  double sum = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t d = kPlaces; d < colours.size(); d = 2 * d + 1, ++pairs)
      sum += colour_distance(colours[i], colours[(i + d) % colours.size()]);
  }
  const float mean = pairs > 0 ? float(sum / double(pairs)) : 0;
  return mean < kPlain ? 0 : mean;
}

class Solver {
 public:
  explicit Solver(const PuzzleInput& input) : scale_(scale_of(input)), watch_(input.watch) {
    for (const auto& polygon : input.pieces) pieces_.push_back(puzzle_piece(polygon, scale_));
    if (!input.frame.empty()) {
      std::vector<Vec2> around(input.frame.rbegin(), input.frame.rend());
      frame_ = int(pieces_.size());
      pieces_.push_back(puzzle_piece(around, scale_));
    }
    for (std::size_t i = 0; i < input.pictures.size(); ++i) pieces_[i].picture = &input.pictures[i];
    scale_.contrast = contrast_of(pieces_, scale_);
    matches_ = piece_matches(
        pieces_, scale_, [&](std::size_t piece) { watch_({.laying = false, .done = piece, .of = pieces_.size()}); });
  }

  /// Pieces among themselves first: what fits a frame's straight edges is found by chance. What pieces alone do not
  /// decide, a frame may.
  PuzzleSolution solve() {
    Arrangement best = solved_alone();
    if (frame_ >= 0 && !(whole(best) && fit_into_frame(best))) {
      const std::vector<Arrangement> starts = beginnings_in_frame();
      if (starts.empty()) return solution_of(std::move(best));
      Arrangement framed = solved(starts);
      if (!whole(framed)) framed = covering_or(std::move(framed));
      if (placed(framed) >= placed(best)) best = std::move(framed);  // else the frame is of another size
    }
    return solution_of(std::move(best));
  }

 private:
  static PuzzleScale scale_of(const PuzzleInput& input) {
    std::vector<double> areas;
    for (const auto& polygon : input.pieces) areas.push_back(signed_area(polygon));
    return PuzzleScale::of(areas);
  }

  static bool ahead(const Arrangement& a, const Arrangement& b) {
    if (a.laid.size() != b.laid.size()) return a.laid.size() > b.laid.size();
    return a.worth > b.worth;
  }

  PosedPiece posed(int piece, const Similarity& pose) const { return {&pieces_[std::size_t(piece)], pose}; }

  /// Without the frame. What matches longest may be strangers that fit each other alone: then what is left over is
  /// tried.
  Arrangement solved_alone() const {
    Arrangement best = solved({beginning(longest_match(std::vector<bool>(pieces_.size())))});
    std::vector<bool> tried = best.used;
    for (int k = 1; k < kMostIslands && 2 * placed(best) < pieces_count(); ++k) {
      Arrangement other = solved({beginning(longest_match(tried))});
      for (std::size_t i = 0; i < tried.size(); ++i) tried[i] = tried[i] || other.used[i];
      if (coherence(other) > coherence(best)) best = std::move(other);
    }
    return best;
  }

  /// The piece with the longest match but for the frame, of those that were not tried.
  int longest_match(const std::vector<bool>& tried) const {
    int longest = 0;
    float most = -1;
    for (std::size_t i = 0; i < pieces_count(); ++i) {
      for (const PieceMatch& match : matches_[i]) {
        if (match.piece == frame_ || tried[i] || match.worth <= most) continue;
        most = match.worth;
        longest = int(i);
      }
    }
    return longest;
  }

  std::size_t pieces_count() const { return pieces_.size() - (frame_ < 0 ? 0 : 1); }

  Arrangement beginning(int first) const {
    Arrangement start;
    start.used.assign(pieces_.size(), false);
    lay({.piece = first}, start);
    return start;
  }

  /// One piece in a corner of the frame, each that may lie in one: from there on pieces follow pieces.
  std::vector<Arrangement> beginnings_in_frame() const {
    Arrangement empty = beginning(frame_);
    std::stable_sort(empty.places.begin(), empty.places.end(),
                     [](const Place& a, const Place& b) { return a.worth > b.worth; });
    if (empty.places.size() > kMostBeginnings) empty.places.resize(kMostBeginnings);
    std::vector<Arrangement> starts;
    const std::vector<Place> places = std::move(empty.places);
    empty.places.clear();
    for (const Place& place : places) {
      starts.push_back(empty);
      lay(place, starts.back());
    }
    return starts;
  }

  /// Each beginning alone, then more and more arrangements at a time, until one is whole.
  Arrangement solved(const std::vector<Arrangement>& starts) const {
    Arrangement best = starts.front();
    const auto follow = [&](const std::vector<Arrangement>& from, int width) {
      Arrangement found = followed_to_the_end(from, width);
      come_to_rest(found);
      drop_loose(found);
      if (coherence(found) > coherence(best)) best = std::move(found);
      return whole(best);
    };
    for (const Arrangement& start : starts) {
      if (follow({start}, 1)) return best;
    }
    const int widest = std::min(64, kMostFollowed / int(pieces_count()));
    for (int width = 8; width <= widest; width *= 8) {
      if (follow(starts, width)) return best;
    }
    return best;
  }

  Arrangement followed_to_the_end(std::vector<Arrangement> followed, int width) const {
    Arrangement best = followed.front();
    while (!followed.empty()) {
      std::vector<Arrangement> next;
      for (const Arrangement& one : followed) {
        if (ahead(one, best)) best = one;
        branch(one, width > 1, next);
      }
      keep_best(next, width);
      followed = std::move(next);
    }
    return best;
  }

  std::size_t placed(const Arrangement& in) const {
    return std::size_t(std::count(in.used.begin(), in.used.begin() + std::ptrdiff_t(pieces_count()), true));
  }

  /// Part of all boundaries that is beside a narrow gap.
  double gaps(const Arrangement& in) const {
    std::size_t all = 0, beside_gap = 0;
    for (const Laid& laid : in.laid) {
      if (laid.piece == frame_) continue;
      const PosedPiece piece = posed(laid.piece, laid.pose);
      std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
      for (const PosedPiece& neighbour : neighbours(piece, in, laid.piece))
        see_neighbour(piece, neighbour, scale_, beside);
      all += beside.size();
      beside_gap += std::size_t(std::count(beside.begin(), beside.end(), Beside::gap));
    }
    return all > 0 ? double(beside_gap) / double(all) : 0;
  }

  /// Of the boundary, as it counts, the part that touches others, and so much times how well the pictures agree there.
  float touching(const Laid& laid, const Arrangement& in, float of_pictures = 0) const {
    const PosedPiece piece = posed(laid.piece, laid.pose);
    std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
    float pictures = 0;
    for (const PosedPiece& neighbour : neighbours(piece, in, laid.piece))
      pictures += see_neighbour(piece, neighbour, scale_, beside);
    float all = 0, touching = 0;
    for (std::size_t k = 0; k < beside.size(); ++k) {
      all += piece.piece->weights[k];
      if (beside[k] == Beside::contact) touching += piece.piece->weights[k];
    }
    return (touching + of_pictures * pictures) / all;
  }

  /// What hardly touches the others does not belong to them: a straight side agrees with any other.
  void drop_loose(Arrangement& in) const {
    for (bool dropped = true; dropped;) {
      dropped = false;
      for (std::size_t i = in.laid.size() - 1; i > 0; --i) {
        if (touching(in.laid[i], in) >= kLeastTouching) continue;
        in.used[std::size_t(in.laid[i].piece)] = false;
        in.laid.erase(in.laid.begin() + std::ptrdiff_t(i));
        dropped = true;
      }
    }
  }

  bool whole(const Arrangement& in) const { return placed(in) == pieces_count() && gaps(in) <= kMostPuzzleGaps; }

  /// How much pieces have in common; what is beside narrow gaps counts against it more than what touches counts for it.
  double coherence(const Arrangement& in) const {
    double sum = 0;
    for (const Laid& laid : in.laid) {
      if (laid.piece != frame_) sum += touching(laid, in, kOfPictures);
    }
    return sum * (1 - kGapsAgainst * gaps(in));
  }

  /// By each piece that may lie in a corner of the frame, or where it has none by all of its outline; false: nowhere
  /// do all lie in it.
  bool fit_into_frame(Arrangement& in) const {
    for (const PieceMatch& match : matches_[std::size_t(frame_)]) {
      const auto corner =
          std::find_if(in.laid.begin(), in.laid.end(), [&](const Laid& l) { return l.piece == match.piece; });
      if (lies_in_frame(in, followed_by(rigid_inverse(corner->pose), match.here_from_there))) return true;
    }
    const std::vector<PosedPiece> laid = laid_pieces(in);
    for (const Similarity& frame_from_puzzle : poses_in_frame(laid, pieces_[std::size_t(frame_)], scale_)) {
      if (lies_in_frame(in, frame_from_puzzle)) return true;
    }
    return false;
  }

  /// The frame filled in any way, or else what there is.
  Arrangement covering_or(Arrangement other) const {
    const auto poses = frame_covering(pieces_, matches_, scale_, [&] { tell(0); });
    if (!poses) return other;
    Arrangement all;
    all.used.assign(pieces_.size(), true);
    all.laid.push_back({frame_, {}});
    for (std::size_t i = 0; i < poses->size(); ++i) all.laid.push_back({int(i), poses->at(i)});
    come_to_rest(all);
    return whole(all) ? all : other;
  }

  std::vector<PosedPiece> laid_pieces(const Arrangement& in) const {
    std::vector<PosedPiece> all;
    for (const Laid& laid : in.laid) all.push_back(posed(laid.piece, laid.pose));
    return all;
  }

  /// Moves all that lies without a frame into it, if it fits.
  bool lies_in_frame(Arrangement& in, const Similarity& frame_from_puzzle) const {
    Arrangement moved;
    moved.used = in.used;
    moved.laid.push_back({frame_, {}});
    for (const Laid& laid : in.laid) moved.laid.push_back({laid.piece, followed_by(laid.pose, frame_from_puzzle)});
    const bool in_it = std::all_of(moved.laid.begin() + 1, moved.laid.end(), [&](const Laid& laid) {
      const Vec2 deepest = laid.pose.apply(pieces_[std::size_t(laid.piece)].deepest);
      return pieces_[std::size_t(frame_)].outline.contains(deepest);
    });
    if (!in_it) return false;
    come_to_rest(moved);
    const bool inside = std::none_of(moved.laid.begin() + 1, moved.laid.end(), [&](const Laid& laid) {
      return overlap(posed(laid.piece, laid.pose), posed(frame_, {}), scale_);
    });
    if (!inside || !whole(moved)) return false;
    in = std::move(moved);
    return true;
  }

  std::vector<PosedPiece> neighbours(const PosedPiece& piece, const Arrangement& in, int but = -1) const {
    std::vector<PosedPiece> all;
    for (const Laid& laid : in.laid) {
      const PosedPiece other = posed(laid.piece, laid.pose);
      if (laid.piece != but && may_touch(piece, other, 4 * scale_.tolerance)) all.push_back(other);
    }
    return all;
  }

  void appraise(Place& place) const {
    const PuzzlePiece& piece = pieces_[std::size_t(place.piece)];
    double worth = 0;
    for (std::size_t k = 0; k < place.beside.size(); ++k) {
      if (place.beside[k] == Beside::contact) worth += piece.weights[k];
      if (place.beside[k] == Beside::gap) worth -= kGapCost * piece.weights[k];
    }
    worth += kOfPictures * place.pictures;
    place.worth = float(worth) * piece.point_length / scale_.piece *
                  kOfSides[std::min<std::size_t>(std::size_t(place.whole_sides), kOfSides.size() - 1)];
  }

  bool is_worth_laying(const Place& place) const {
    const PuzzlePiece& piece = pieces_[std::size_t(place.piece)];
    const float all =
        std::accumulate(piece.weights.begin(), piece.weights.end(), 0.f) * piece.point_length / scale_.piece;
    return place.worth >= std::min(kLeastWorth, kLeastPart * all);
  }

  bool same_place(const Place& a, const Place& b) const {
    if (a.piece != b.piece) return false;
    const Vec2 centre = pieces_[std::size_t(a.piece)].centre;
    const Vec2 off = a.pose.apply(centre) - b.pose.apply(centre);
    const float turned = 1 - (a.pose.a * b.pose.a + a.pose.b * b.pose.b);
    return norm(off) < 4 * scale_.tolerance && turned < 0.005f;
  }

  /// Whether only one of them can come true.
  bool rivals(const Place& a, const Place& b) const {
    if (a.piece == b.piece) return true;
    const PuzzlePiece &p = pieces_[std::size_t(a.piece)], &q = pieces_[std::size_t(b.piece)];
    const Vec2 off = a.pose.apply(p.centre) - b.pose.apply(q.centre);
    return norm(off) < 0.3f * float(std::sqrt(p.area) + std::sqrt(q.area));
  }

  void lay(const Place& place, Arrangement& in) const {
    tell(placed(in));
    const PosedPiece rough = posed(place.piece, place.pose);
    const std::vector<PosedPiece> around = neighbours(rough, in);
    const Similarity pose = around.empty() ? place.pose : settled(rough, around, scale_, kSettlingSteps);
    const PosedPiece piece = posed(place.piece, pose);
    in.laid.push_back({place.piece, pose});
    in.used[std::size_t(place.piece)] = true;
    in.worth += place.worth;
    std::erase_if(in.places, [&](const Place& other) {
      return other.piece == place.piece || overlap(posed(other.piece, other.pose), piece, scale_);
    });
    for (Place& other : in.places) {
      const PosedPiece p = posed(other.piece, other.pose);
      if (!may_touch(p, piece, 4 * scale_.tolerance)) continue;
      other.pictures += see_neighbour(p, piece, scale_, other.beside);
      appraise(other);
    }
    add_places_beside(in.laid.back(), in);
    if (in.places.size() <= kMostPlaces) return;
    std::stable_sort(in.places.begin(), in.places.end(),
                     [](const Place& a, const Place& b) { return a.worth > b.worth; });
    in.places.resize(kMostPlaces);
  }

  void add_places_beside(const Laid& laid, Arrangement& in) const {
    for (const PieceMatch& match : matches_[std::size_t(laid.piece)]) {
      if (match.piece == frame_ || in.used[std::size_t(match.piece)]) continue;
      Place place{.piece = match.piece,
                  .pose = followed_by(match.here_from_there, laid.pose),
                  .whole_sides = match.whole_side ? 1 : 0};
      const auto there =
          std::find_if(in.places.begin(), in.places.end(), [&](const Place& p) { return same_place(p, place); });
      if (there != in.places.end()) {
        there->whole_sides += place.whole_sides;
        appraise(*there);
        continue;
      }
      const PosedPiece piece = posed(place.piece, place.pose);
      const std::vector<PosedPiece> around = neighbours(piece, in);
      if (std::any_of(around.begin(), around.end(), [&](const PosedPiece& p) { return overlap(piece, p, scale_); }))
        continue;
      place.beside.assign(piece.piece->points.size(), Beside::nothing);
      for (const PosedPiece& neighbour : around)
        place.pictures += see_neighbour(piece, neighbour, scale_, place.beside);
      appraise(place);
      if (place.worth > 0) in.places.push_back(std::move(place));
    }
  }

  /// In the frame's corners a piece may lie that no neighbour's side leads to.
  Arrangement with_open_frame(Arrangement one) const {
    one.frame_is_open = true;
    add_places_beside(one.laid.front(), one);
    return one;
  }

  /// The place that leads most over its rivals, and with it the best of those.
  void branch(const Arrangement& one, bool with_rivals, std::vector<Arrangement>& next) const {
    std::vector<float> rival(one.places.size(), 0);
    for (std::size_t i = 0; i < one.places.size(); ++i) {
      for (std::size_t j = i + 1; j < one.places.size(); ++j) {
        if (!rivals(one.places[i], one.places[j])) continue;
        rival[i] = std::max(rival[i], one.places[j].worth);
        rival[j] = std::max(rival[j], one.places[i].worth);
      }
    }
    std::size_t surest = 0;
    const auto lead = [&](std::size_t i) { return one.places[i].worth - rival[i]; };
    for (std::size_t i = 1; i < one.places.size(); ++i) {
      const bool counts = is_worth_laying(one.places[i]), did = is_worth_laying(one.places[surest]);
      if (counts != did ? counts : lead(i) > lead(surest)) surest = i;
    }
    if (one.places.empty() || !is_worth_laying(one.places[surest])) {
      if (frame_ >= 0 && !one.frame_is_open && one.laid.front().piece == frame_)
        branch(with_open_frame(one), with_rivals, next);
      return;
    }
    std::vector<std::size_t> options;
    for (std::size_t i = 0; with_rivals && i < one.places.size(); ++i) {
      if (i != surest && rivals(one.places[i], one.places[surest]) &&
          one.places[i].worth > 0.5f * one.places[surest].worth)
        options.push_back(i);
    }
    std::stable_sort(options.begin(), options.end(),
                     [&](std::size_t a, std::size_t b) { return one.places[a].worth > one.places[b].worth; });
    if (options.size() > kMostBranches - 1) options.resize(kMostBranches - 1);
    options.insert(options.begin(), surest);
    for (const std::size_t option : options) {
      next.push_back(one);
      lay(Place(one.places[option]), next.back());
    }
  }

  /// The same pieces, laid equally well: as a rule in the same places, whatever their order.
  bool same(const Arrangement& a, const Arrangement& b) const {
    return a.used == b.used && std::abs(a.worth - b.worth) < 1e-3;
  }

  void keep_best(std::vector<Arrangement>& all, int width) const {
    std::stable_sort(all.begin(), all.end(), [](const Arrangement& a, const Arrangement& b) { return ahead(a, b); });
    std::vector<Arrangement> kept;
    for (Arrangement& one : all) {
      if (int(kept.size()) == width) break;
      if (std::none_of(kept.begin(), kept.end(), [&](const Arrangement& k) { return same(k, one); }))
        kept.push_back(std::move(one));
    }
    all = std::move(kept);
  }

  void come_to_rest(Arrangement& in) const {
    for (int round = 0; round < kLastRounds; ++round) {
      tell(placed(in));
      for (std::size_t i = 1; i < in.laid.size(); ++i) {  // the first stays: the frame, or what the others lie round
        Laid& laid = in.laid[i];
        const PosedPiece piece = posed(laid.piece, laid.pose);
        laid.pose = settled(piece, neighbours(piece, in, laid.piece), scale_, 1);
      }
    }
  }

  /// Pieces of one outline to where their pictures agree best. Returns how many might as well lie elsewhere.
  int exchange_alike(Arrangement& in) const {
    const std::size_t first = in.laid.front().piece == frame_ ? 1 : 0;
    const std::vector<PosedPiece> all = laid_pieces(in);
    const ExchangedPieces now =
        exchanged({all.begin() + std::ptrdiff_t(first), all.end()}, scale_, [&] { tell(placed(in)); });
    bool moved = false;
    for (std::size_t i = first; i < in.laid.size(); ++i) {
      moved = moved || !(in.laid[i].pose == now.poses[i - first]);
      in.laid[i].pose = now.poses[i - first];
    }
    if (moved) come_to_rest(in);
    return now.undecided;
  }

  PuzzleSolution solution_of(Arrangement best) const {
    PuzzleSolution solution;
    solution.undecided = exchange_alike(best);
    solution.poses.resize(pieces_count());
    for (const Laid& laid : best.laid) {
      if (laid.piece != frame_) solution.poses[std::size_t(laid.piece)] = laid.pose;
    }
    solution.placed = int(placed(best));
    solution.in_frame = best.laid.front().piece == frame_;
    solution.gaps = gaps(best);
    return solution;
  }

  /// Of the arrangement that is being laid.
  void tell(std::size_t laid) const { watch_({.laying = true, .done = laid, .of = pieces_count()}); }

  PuzzleScale scale_;
  const std::function<void(const PuzzleProgress&)>& watch_;
  std::vector<PuzzlePiece> pieces_;
  int frame_ = -1;
  std::vector<std::vector<PieceMatch>> matches_;
};

}  // namespace

PuzzleSolution solve_puzzle(const PuzzleInput& input) {
  if (input.pieces.empty()) return {};
  return Solver(input).solve();
}

}  // namespace tessera
