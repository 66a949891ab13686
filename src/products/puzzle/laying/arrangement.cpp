#include "products/puzzle/laying/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "products/puzzle/laying/joint_settling.h"
#include "products/puzzle/laying/puzzle_solver.h"

namespace tessera {
namespace {

/// The cost of a boundary beside a gap, in units of what a touching boundary is worth.
constexpr float kGapCost = 1;
/// The worth that agreement (of pictures, and of the closeness of boundaries) adds to a touching boundary. Disagreement takes
/// as much away. The boundary itself is worth 1 where it is bent and 0.3 where it is straight.
constexpr float kOfAgreement = 0.5f;
/// Upper bound of branches: the surest place, and the best places that exclude it.
constexpr std::size_t kMostBranches = 4;
/// Factor for a place's contact, by its matches from corner to corner (PuzzlePlace::whole_sides): one may be chance, two
/// hardly.
constexpr std::array<float, 4> kOfSides = {0.5f, 1, 2, 3};
/// Coherence is nearly 0 where a tenth of the boundaries is beside narrow gaps, and still grows with the number of pieces.
constexpr double kGapsAgainst = 10;
constexpr double kLeastCoherent = 0.05;
/// The least worth of a place, in sides of a piece, because so much agrees by chance; or, for small pieces, as a part of
/// the worth that the place would have if all of its boundary touched.
constexpr float kLeastWorth = 0.3f;
constexpr float kLeastPart = 0.5f;
/// The largest part of gaps beside a piece, relative to what touches. A piece where another belongs has 15 to 36 %, a piece
/// in its own place at most 7 % (400 pieces that have lost a pixel).
constexpr float kMostBesideGaps = 0.12f;
/// Upper bound of the places of an arrangement, of which the best are kept. A puzzle of 400 pieces has some hundreds, other
/// drawings may have any number.
constexpr std::size_t kMostPlaces = 4'000;
/// Steps of settling for a piece that is laid, and for all pieces in the end.
constexpr int kSettlingSteps = 3;
constexpr int kLastSteps = 4;

bool ahead(const Arrangement& a, const Arrangement& b) {
  if (a.laid.size() != b.laid.size()) return a.laid.size() > b.laid.size();
  return a.worth > b.worth;
}

}  // namespace

Arrangement PuzzleArranger::beginning(int first) const {
  Arrangement start;
  start.used.assign(pieces_.size(), false);
  lay({.piece = first}, start);
  return start;
}

std::vector<PosedPiece> PuzzleArranger::laid_pieces(const Arrangement& in) const {
  std::vector<PosedPiece> all;
  for (const LaidPiece& laid : in.laid) all.push_back(posed(laid));
  return all;
}

std::size_t PuzzleArranger::placed(const Arrangement& in) const {
  return std::size_t(std::count(in.used.begin(), in.used.begin() + std::ptrdiff_t(pieces_count()), true));
}

double PuzzleArranger::gaps(const Arrangement& in) const {
  std::size_t all = 0, beside_gap = 0;
  for (const LaidPiece& laid : in.laid) {
    if (is_frame(laid)) continue;
    report(in);
    const PosedPiece piece = posed(laid);
    std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
    for (const PosedPiece& neighbour : neighbours(piece, in, laid.piece))
      see_neighbour(piece, neighbour, scale_, beside);
    all += beside.size();
    beside_gap += std::size_t(std::count(beside.begin(), beside.end(), Beside::gap));
  }
  return all > 0 ? double(beside_gap) / double(all) : 0;
}

PuzzleArranger::Boundary PuzzleArranger::boundary_of(const LaidPiece& laid, const Arrangement& in) const {
  report(in);
  const PosedPiece piece = posed(laid);
  std::vector<Beside> beside(piece.piece->points.size(), Beside::nothing);
  Boundary boundary;
  for (const PosedPiece& neighbour : neighbours(piece, in, laid.piece))
    boundary.agreement += see_neighbour(piece, neighbour, scale_, beside);
  float all = 0;
  for (std::size_t k = 0; k < beside.size(); ++k) {
    const float weight = piece.piece->weights[k];
    all += weight;
    if (beside[k] == Beside::contact) boundary.touching += weight;
    if (beside[k] == Beside::gap) boundary.beside_gaps += weight;
  }
  return {boundary.touching / all, boundary.beside_gaps / all, boundary.agreement / all};
}

void PuzzleArranger::drop_loose(float least_touching, Arrangement& in) const {
  for (bool dropped = true; dropped;) {
    dropped = false;
    for (std::size_t i = in.laid.size() - 1; i > 0; --i) {
      if (boundary_of(in.laid[i], in).touching >= least_touching) continue;
      in.used[std::size_t(in.laid[i].piece)] = false;
      in.laid.erase(in.laid.begin() + std::ptrdiff_t(i));
      dropped = true;
    }
  }
}

void PuzzleArranger::drop_misfits(Arrangement& in) const {
  std::vector<LaidPiece> kept = {in.laid.front()};
  for (std::size_t i = 1; i < in.laid.size(); ++i) {
    const Boundary boundary = boundary_of(in.laid[i], in);
    const bool fits = boundary.beside_gaps <= kMostBesideGaps * boundary.touching;
    if (fits) kept.push_back(in.laid[i]);
    in.used[std::size_t(in.laid[i].piece)] = fits;
  }
  in.laid = std::move(kept);
}

bool PuzzleArranger::whole(const Arrangement& in) const {
  return placed(in) == pieces_count() && gaps(in) <= kMostPuzzleGaps;
}

double PuzzleArranger::coherence(const Arrangement& in) const {
  double sum = 0;
  for (const LaidPiece& laid : in.laid) {
    if (is_frame(laid)) continue;
    const Boundary boundary = boundary_of(laid, in);
    sum += double(boundary.touching + kOfAgreement * boundary.agreement);
  }
  return std::max(0., sum) * std::max(kLeastCoherent, 1 - kGapsAgainst * gaps(in));
}

std::vector<PosedPiece> PuzzleArranger::neighbours(const PosedPiece& piece, const Arrangement& in, int but) const {
  std::vector<PosedPiece> all;
  for (const LaidPiece& laid : in.laid) {
    const PosedPiece other = posed(laid);
    if (laid.piece != but && may_touch(piece, other, 4 * scale_.tolerance)) all.push_back(other);
  }
  return all;
}

/// Settles the place between all pieces around it: the match that led to it knew only one of them.
void PuzzleArranger::settle(PuzzlePlace& place, const std::vector<PosedPiece>& around) const {
  place.pose = settled(posed({place.piece, place.pose}), around, scale_, 1);
  const PosedPiece piece = posed({place.piece, place.pose});
  place.beside.assign(piece.piece->points.size(), Beside::nothing);
  place.agreement = 0;
  for (const PosedPiece& neighbour : around) place.agreement += see_neighbour(piece, neighbour, scale_, place.beside);
  appraise(place);
}

void PuzzleArranger::appraise(PuzzlePlace& place) const {
  const PuzzlePiece& piece = pieces_[std::size_t(place.piece)];
  double worth = 0;
  for (std::size_t k = 0; k < place.beside.size(); ++k) {
    if (place.beside[k] == Beside::contact) worth += piece.weights[k];
    if (place.beside[k] == Beside::gap) worth -= kGapCost * piece.weights[k];
  }
  worth += kOfAgreement * place.agreement;
  place.worth = float(worth) * piece.point_length / scale_.piece *
                kOfSides[std::min<std::size_t>(std::size_t(place.whole_sides), kOfSides.size() - 1)];
}

bool PuzzleArranger::is_worth_laying(const PuzzlePlace& place) const {
  const PuzzlePiece& piece = pieces_[std::size_t(place.piece)];
  const float all =
      std::accumulate(piece.weights.begin(), piece.weights.end(), 0.f) * piece.point_length / scale_.piece;
  return place.worth >= std::min(kLeastWorth, kLeastPart * all);
}

bool PuzzleArranger::same_place(const PuzzlePlace& a, const PuzzlePlace& b) const {
  if (a.piece != b.piece) return false;
  const Vec2 centre = pieces_[std::size_t(a.piece)].centre;
  const Vec2 off = a.pose.apply(centre) - b.pose.apply(centre);
  const float turned = 1 - (a.pose.a * b.pose.a + a.pose.b * b.pose.b);
  return norm(off) < 4 * scale_.tolerance && turned < 0.005f;
}

/// Whether only one of the two places can be used.
bool PuzzleArranger::exclude_each_other(const PuzzlePlace& a, const PuzzlePlace& b) const {
  if (a.piece == b.piece) return true;
  const PuzzlePiece &p = pieces_[std::size_t(a.piece)], &q = pieces_[std::size_t(b.piece)];
  const Vec2 off = a.pose.apply(p.centre) - b.pose.apply(q.centre);
  return norm(off) < 0.3f * float(std::sqrt(p.area) + std::sqrt(q.area));
}

void PuzzleArranger::lay(const PuzzlePlace& place, Arrangement& in) const {
  report(in);
  const PosedPiece rough = posed({place.piece, place.pose});
  const std::vector<PosedPiece> around = neighbours(rough, in);
  const Similarity pose = around.empty() ? place.pose : settled(rough, around, scale_, kSettlingSteps);
  const PosedPiece piece = posed({place.piece, pose});
  in.laid.push_back({place.piece, pose});
  in.used[std::size_t(place.piece)] = true;
  in.worth += place.worth;
  std::erase_if(in.places, [&](const PuzzlePlace& other) {
    return other.piece == place.piece || overlap(posed({other.piece, other.pose}), piece, scale_);
  });
  const auto beside = std::stable_partition(in.places.begin(), in.places.end(), [&](const PuzzlePlace& other) {
    return !may_touch(posed({other.piece, other.pose}), piece, 4 * scale_.tolerance);
  });
  std::vector<PuzzlePlace> moved(std::make_move_iterator(beside), std::make_move_iterator(in.places.end()));
  in.places.erase(beside, in.places.end());
  for (PuzzlePlace& other : moved) {
    settle(other, neighbours(posed({other.piece, other.pose}), in));
    add_place(std::move(other), in);
  }
  add_places_beside(in.laid.back(), in);
  if (in.places.size() <= kMostPlaces) return;
  std::stable_sort(in.places.begin(), in.places.end(),
                   [](const PuzzlePlace& a, const PuzzlePlace& b) { return a.worth > b.worth; });
  in.places.resize(kMostPlaces);
}

/// Joins the place with an equal one, which then counts the whole sides of both matches.
bool PuzzleArranger::joins_a_place(const PuzzlePlace& place, Arrangement& in) const {
  const auto there =
      std::find_if(in.places.begin(), in.places.end(), [&](const PuzzlePlace& p) { return same_place(p, place); });
  if (there == in.places.end()) return false;
  there->whole_sides += place.whole_sides;
  appraise(*there);
  return true;
}

void PuzzleArranger::add_place(PuzzlePlace place, Arrangement& in) const {
  if (!joins_a_place(place, in)) in.places.push_back(std::move(place));
}

void PuzzleArranger::add_places_beside(const LaidPiece& laid, Arrangement& in) const {
  for (const PieceMatch& match : matches_[std::size_t(laid.piece)]) {
    if (match.piece == frame_ || in.used[std::size_t(match.piece)]) continue;
    PuzzlePlace place{.piece = match.piece,
                      .pose = followed_by(match.here_from_there, laid.pose),
                      .whole_sides = match.whole_side ? 1 : 0};
    if (joins_a_place(place, in)) continue;  // before settling, which takes longer
    report(in);
    const PosedPiece piece = posed({place.piece, place.pose});
    const std::vector<PosedPiece> around = neighbours(piece, in);
    if (std::any_of(around.begin(), around.end(), [&](const PosedPiece& p) { return overlap(piece, p, scale_); }))
      continue;
    settle(place, around);
    if (place.worth > 0) add_place(std::move(place), in);
  }
}

void PuzzleArranger::find_places(Arrangement& in) const {
  in.places.clear();
  in.frame_is_open = false;
  for (const LaidPiece& laid : in.laid) {
    if (!is_frame(laid)) add_places_beside(laid, in);
  }
}

/// Adds places along the frame: in its corners a piece may lie that no neighbour's side leads to.
Arrangement PuzzleArranger::with_open_frame(Arrangement one) const {
  one.frame_is_open = true;
  add_places_beside(one.laid.front(), one);
  return one;
}

/// Adds to `next` the arrangement with the surest place: the one whose worth exceeds that of the places it excludes the most.
/// `with_excluded`: also adds those with the best of the excluded places.
void PuzzleArranger::branch(const Arrangement& one, bool with_excluded, std::vector<Arrangement>& next) const {
  std::vector<float> rival(one.places.size(), 0);
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    for (std::size_t j = i + 1; j < one.places.size(); ++j) {
      if (!exclude_each_other(one.places[i], one.places[j])) continue;
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
    if (frame_ >= 0 && !one.frame_is_open && is_frame(one.laid.front()))
      branch(with_open_frame(one), with_excluded, next);
    return;
  }
  std::vector<std::size_t> options;
  for (std::size_t i = 0; with_excluded && i < one.places.size(); ++i) {
    if (i != surest && exclude_each_other(one.places[i], one.places[surest]) &&
        one.places[i].worth > 0.5f * one.places[surest].worth)
      options.push_back(i);
  }
  std::stable_sort(options.begin(), options.end(),
                   [&](std::size_t a, std::size_t b) { return one.places[a].worth > one.places[b].worth; });
  if (options.size() > kMostBranches - 1) options.resize(kMostBranches - 1);
  options.insert(options.begin(), surest);
  for (const std::size_t option : options) {
    next.push_back(one);
    lay(PuzzlePlace(one.places[option]), next.back());
  }
}

/// Whether the same pieces are laid equally well. Usually they then lie in the same places, in any order.
bool PuzzleArranger::same(const Arrangement& a, const Arrangement& b) const {
  return a.used == b.used && std::abs(a.worth - b.worth) < 1e-3;
}

void PuzzleArranger::keep_best(std::vector<Arrangement>& all, int width) const {
  std::stable_sort(all.begin(), all.end(), [](const Arrangement& a, const Arrangement& b) { return ahead(a, b); });
  std::vector<Arrangement> kept;
  for (Arrangement& one : all) {
    if (int(kept.size()) == width) break;
    if (std::none_of(kept.begin(), kept.end(), [&](const Arrangement& k) { return same(k, one); }))
      kept.push_back(std::move(one));
  }
  all = std::move(kept);
}

void PuzzleArranger::settle_all(Arrangement& in) const {
  std::vector<PosedPiece> pieces = laid_pieces(in);
  settle_jointly(pieces, scale_, kLastSteps, [&] { report(in); });
  for (std::size_t i = 0; i < pieces.size(); ++i) in.laid[i].pose = pieces[i].pose;
}

Arrangement PuzzleArranger::followed_to_the_end(std::vector<Arrangement> followed, int width) const {
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

}  // namespace tessera
