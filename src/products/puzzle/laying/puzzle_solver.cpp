#include "products/puzzle/laying/puzzle_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/geometry/polygon.h"
#include "products/puzzle/laying/arrangement.h"
#include "products/puzzle/laying/frame_covering.h"
#include "products/puzzle/laying/piece_exchange.h"
#include "products/puzzle/laying/poses_in_frame.h"
#include "products/puzzle/laying/within_frame.h"
#include "products/puzzle/pieces/piece_erosion.h"
#include "products/puzzle/pieces/piece_matches.h"
#include "products/puzzle/pieces/puzzle_contact.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {
namespace {

/// Beginnings without a frame, for puzzles in which most pieces do not fit together.
constexpr int kMostIslands = 4;
/// The most pieces that are tried in a corner of the frame.
constexpr std::size_t kMostBeginnings = 16;
/// Arrangements times pieces: a puzzle of more than 250 pieces is solved greedily.
constexpr int kMostFollowed = 2'000;
/// The most arrangements that are followed at a time, also beside pieces that were moved into the frame.
constexpr int kWidest = 64, kWidestBesideMoved = 8;
/// The most arrangements if pieces may be grown in several ways. The cheap search is made for all ways first.
constexpr std::array<int, 2> kWidestInTurn = {1, 8};
/// The part of a frame that counts as full, because outlines are not exact; other pieces are foreign.
constexpr double kFull = 0.985;
/// Poses in the frame of what was laid without it that are tried in full.
constexpr std::size_t kMostMoves = 4;
/// Scales that differ by less count as equal; filling the frame tells the scale better.
constexpr double kSameScale = 0.01;
/// A piece of which less than this part touches others may hang outside by a straight side, while its place is a hole.
constexpr float kLeastHeld = 0.5f;
/// The largest number of fillings of holes, and the least gain of coherence each time.
constexpr int kMostFillings = 8;
constexpr double kLeastFuller = 1e-6;
/// Larger frames to try where nearly all pieces lie, and the growth from one to the next.
constexpr int kLargerFrames = 4;
constexpr double kLarger = 0.001;

/// The mean distance of the pictures' colours between places of different pieces, along their boundaries. 0 without
/// pictures, and for plain ones.
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

PuzzleScale scale_of(const std::vector<std::vector<Vec2>>& pieces) {
  std::vector<double> areas;
  for (const auto& polygon : pieces) areas.push_back(signed_area(polygon));
  return PuzzleScale::of(areas);
}

struct Solved {
  PuzzleSolution solution = {};
  bool done = false;     // no piece is left, or no room in the frame, and the laid pieces fit
  double coherence = 0;  // PuzzleArranger::coherence
};

class Solver {
 public:
  Solver(const PuzzleInput& input, int widest)
      : widest_(widest),
        scale_(scale_of(input.pieces)),
        watch_(input.watch),
        frame_(input.frame.empty() ? -1 : int(input.pieces.size())),
        arranger_(pieces_, matches_, scale_, frame_, [this](std::size_t laid) { report_laying(laid); }) {
    for (const auto& polygon : input.pieces) {
      pieces_.push_back(puzzle_piece(polygon, scale_));
      watch_({.laying = false, .done = 0, .of = input.pieces.size()});
    }
    if (frame_ >= 0) pieces_.push_back(frame_piece(input.frame, 1));
    for (std::size_t i = 0; i < input.pictures.size(); ++i) pieces_[i].picture = &input.pictures[i];
    scale_.contrast = contrast_of(pieces_, scale_);
    matches_ = piece_matches(pieces_, scale_, report_matching());
  }

  /// Solves the puzzle. The pieces are first laid without the frame, because matches with its straight edges are often
  /// chance. The frame may decide what the pieces alone do not.
  Solved solve(const PuzzleInput& input) {
    Arrangement alone = solved_alone();
    if (frame_ < 0 || (arranger_.whole(alone) && fit_into_frame(alone))) return solution_of(std::move(alone));
    if (!input.frame_fits && take_scale(alone, input.frame) && fit_into_frame(alone))
      return solution_of(std::move(alone));
    Arrangement in_frame = solved_in_frame(alone);
    if (!input.frame_fits) in_frame = in_larger_frames(std::move(in_frame), input.frame);
    Solved solved = solution_of(std::move(in_frame));
    if (arranger_.whole(alone) && solved.solution.placed < int(arranger_.pieces_count()))
      solved.solution.without_frame = poses_of_pieces(alone);
    return solved;
  }

 private:
  /// The frame for pieces that are `times` as large.
  PuzzlePiece frame_piece(const std::vector<Vec2>& frame, double times) const {
    std::vector<Vec2> around(frame.rbegin(), frame.rend());
    for (Vec2& p : around) p = p * float(1 / times);
    return puzzle_piece(around, scale_);
  }

  /// Solves without the frame. The longest match may join foreign pieces that only fit each other; then the remaining
  /// pieces are tried.
  Arrangement solved_alone() const {
    Arrangement best = solved({arranger_.beginning(longest_match(std::vector<bool>(pieces_.size())))}, widest_);
    std::vector<bool> tried = best.used;
    for (int k = 1; k < kMostIslands && 2 * arranger_.placed(best) < arranger_.pieces_count(); ++k) {
      Arrangement other = solved({arranger_.beginning(longest_match(tried))}, widest_);
      for (std::size_t i = 0; i < tried.size(); ++i) tried[i] = tried[i] || other.used[i];
      if (arranger_.coherence(other) > arranger_.coherence(best)) best = std::move(other);
    }
    return best;
  }

  /// The piece with the longest match, without the frame, among those that were not tried.
  int longest_match(const std::vector<bool>& tried) const {
    int longest = 0;
    float most = -1;
    for (std::size_t i = 0; i < arranger_.pieces_count(); ++i) {
      for (const PieceMatch& match : matches_[i]) {
        if (match.piece == frame_ || tried[i] || match.worth <= most) continue;
        most = match.worth;
        longest = int(i);
      }
    }
    return longest;
  }

  std::vector<Similarity> poses_of_pieces(const Arrangement& in) const {
    std::vector<Similarity> poses(arranger_.pieces_count());
    for (const LaidPiece& laid : in.laid) poses[std::size_t(laid.piece)] = laid.pose;
    return poses;
  }

  /// Follows each beginning alone, then more and more arrangements at a time, until one is whole.
  Arrangement solved(const std::vector<Arrangement>& starts, int widest) const {
    Arrangement best = starts.front();
    const auto follow = [&](const std::vector<Arrangement>& from, int width) {
      const Arrangement found = filled_up(settled(arranger_.followed_to_the_end(from, width)));
      if (arranger_.coherence(found) > arranger_.coherence(best)) best = found;
      return arranger_.whole(best);
    };
    for (const Arrangement& start : starts) {
      if (follow({start}, 1)) return best;
    }
    widest = std::min(widest, kMostFollowed / int(arranger_.pieces_count()));
    for (int width = 8; width <= widest; width *= 8) {
      if (follow(starts, width)) return best;
    }
    return best;
  }

  Arrangement settled(Arrangement found) const {
    arranger_.settle_all(found);
    if (arranger_.is_frame(found.laid.front())) keep_within_frame(found, arranger_);
    arranger_.drop_loose(kLeastTouching, found);
    return found;
  }

  /// Fills holes after all pieces have settled: small errors have disappeared, so there may be room, and pieces in wrong
  /// places show. The arrangement with more coherence wins, even with a piece less, because the next round may lay that
  /// again.
  Arrangement filled_up(Arrangement found) const {
    double coherence = arranger_.coherence(found);
    for (int round = 0; round < kMostFillings; ++round) {
      bool better = false;
      for (const bool hanging_too : {false, true}) {
        const Arrangement sound = without_misfits(found, hanging_too);
        if (sound.laid.size() == found.laid.size() &&
            (hanging_too || arranger_.placed(sound) == arranger_.pieces_count()))
          continue;
        Arrangement fuller = settled(arranger_.followed_to_the_end({with_places(sound)}, 1));
        const double now = arranger_.coherence(fuller);
        better = now > coherence * (1 + kLeastFuller);
        if (!better) continue;
        coherence = now;
        found = std::move(fuller);
        break;
      }
      if (!better) break;
    }
    return found;
  }

  /// The arrangement without pieces that lie where others belong; `hanging_too`: also without hanging ones. Hanging pieces
  /// stay where less than half would be left, as with straight-sided pieces, which touch each other little.
  Arrangement without_misfits(const Arrangement& found, bool hanging_too) const {
    Arrangement sound = found;
    arranger_.drop_misfits(sound);
    if (!hanging_too) return sound;
    Arrangement held = sound;
    arranger_.drop_loose(kLeastHeld, held);
    if (held.laid.size() == sound.laid.size() || 2 * held.laid.size() < sound.laid.size()) return found;
    return held;
  }

  /// Poses in the frame of what was laid without it: by each piece that may lie in a corner of the frame, or by its outer
  /// boundary.
  std::vector<Similarity> poses_of(const Arrangement& alone) const {
    std::vector<Similarity> poses;
    for (const PieceMatch& match : matches_[std::size_t(frame_)]) {
      const auto corner = std::find_if(alone.laid.begin(), alone.laid.end(),
                                       [&](const LaidPiece& laid) { return laid.piece == match.piece; });
      if (corner != alone.laid.end()) poses.push_back(followed_by(rigid_inverse(corner->pose), match.here_from_there));
    }
    const std::vector<PosedPiece> laid = arranger_.laid_pieces(alone);
    for (const Similarity& pose : poses_in_frame(laid, pieces_[std::size_t(frame_)], scale_)) poses.push_back(pose);
    return poses;
  }

  /// Moves the arrangement into the frame. False: there is no pose in which all pieces lie in it and fit.
  bool fit_into_frame(Arrangement& in) const {
    for (const Similarity& frame_from_puzzle : poses_of(in)) {
      if (pieces_within_frame(in, frame_from_puzzle, arranger_) < arranger_.placed(in)) continue;
      Arrangement moved = moved_into_frame(in, frame_from_puzzle, arranger_);
      if (!arranger_.whole(moved)) continue;
      in = std::move(moved);
      return true;
    }
    return false;
  }

  /// Takes the scale at which the laid pieces reach the frame's edges, if it differs. False: nothing changed.
  bool take_scale(const Arrangement& alone, const std::vector<Vec2>& frame) {
    const auto pose = scaled_pose_in_frame(arranger_.laid_pieces(alone), pieces_[std::size_t(frame_)], scale_);
    if (!pose || std::abs(double(pose->scale()) - 1) < kSameScale) return false;
    set_scale(double(pose->scale()), frame);
    return true;
  }

  void set_scale(double times, const std::vector<Vec2>& frame) {
    times_ = times;
    pieces_[std::size_t(frame_)] = frame_piece(frame, times_);
    match_frame_anew(pieces_, scale_, matches_, report_matching());
  }

  /// A scale computed from areas has small errors, so that the last row may find no room. Where most pieces lie, this tries
  /// slightly larger frames.
  Arrangement in_larger_frames(Arrangement best, const std::vector<Vec2>& frame) {
    const double first = times_;
    double best_times = times_;
    for (int k = 1; k <= kLargerFrames; ++k) {
      const std::size_t placed = arranger_.placed(best);
      if (placed == arranger_.pieces_count() || 4 * placed < 3 * arranger_.pieces_count()) break;
      set_scale(first / (1 + kLarger * k), frame);
      Arrangement larger = filled_up(settled(best));
      if (arranger_.placed(larger) <= placed || arranger_.coherence(larger) <= arranger_.coherence(best)) continue;
      best = std::move(larger);
      best_times = times_;
    }
    if (times_ != best_times) set_scale(best_times, frame);
    return best;
  }

  /// Solves in the frame, with as many pieces as fit together.
  Arrangement solved_in_frame(const Arrangement& alone) const {
    const Arrangement moved = best_moved(alone);
    const bool sound = arranger_.placed(moved) == arranger_.placed(alone) &&
                       2 * arranger_.placed(alone) > arranger_.pieces_count() &&
                       arranger_.gaps(moved) <= kMostPuzzleGaps;
    if (sound) return solved({with_places(moved)}, kWidestBesideMoved);
    Arrangement best = covering_or(from_corners());
    if (arranger_.whole(best)) return best;
    Arrangement grown = solved({with_places(moved)}, kWidestBesideMoved);
    return arranger_.coherence(grown) > arranger_.coherence(best) ? grown : best;
  }

  Arrangement with_places(Arrangement in) const {
    arranger_.find_places(in);
    return in;
  }

  /// Moves what was laid without the frame into it, where most of it fits; the rest is taken out.
  Arrangement best_moved(const Arrangement& alone) const {
    std::vector<std::pair<std::size_t, Similarity>> tried;
    for (const Similarity& pose : poses_of(alone))
      tried.emplace_back(pieces_within_frame(alone, pose, arranger_), pose);
    std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Similarity> followed;
    for (const auto& [within, pose] : tried) {
      const auto same = [&, &pose = pose](const Similarity& other) { return same_move(alone, pose, other); };
      if (followed.size() < kMostMoves && std::none_of(followed.begin(), followed.end(), same))
        followed.push_back(pose);
    }
    Arrangement best = empty_frame();
    for (const Similarity& pose : followed) {
      Arrangement moved = moved_into_frame(alone, pose, arranger_);
      if (arranger_.coherence(moved) > arranger_.coherence(best)) best = std::move(moved);
    }
    return best;
  }

  bool same_move(const Arrangement& alone, const Similarity& a, const Similarity& b) const {
    return std::all_of(alone.laid.begin(), alone.laid.end(), [&](const LaidPiece& laid) {
      const Vec2 centre = laid.pose.apply(pieces_[std::size_t(laid.piece)].centre);
      return norm(a.apply(centre) - b.apply(centre)) < scale_.piece / 4;
    });
  }

  Arrangement empty_frame() const {
    Arrangement empty;
    empty.used.assign(pieces_.size(), false);
    empty.laid.push_back({frame_, {}});
    return empty;
  }

  /// Begins with one piece in a corner of the frame, each that may lie in one; others follow from there.
  Arrangement from_corners() const {
    Arrangement empty = arranger_.beginning(frame_);
    std::stable_sort(empty.places.begin(), empty.places.end(),
                     [](const PuzzlePlace& a, const PuzzlePlace& b) { return a.worth > b.worth; });
    if (empty.places.size() > kMostBeginnings) empty.places.resize(kMostBeginnings);
    const std::vector<PuzzlePlace> places = std::move(empty.places);
    empty.places.clear();
    if (places.empty()) return empty;
    std::vector<Arrangement> starts;
    for (const PuzzlePlace& place : places) {
      starts.push_back(empty);
      arranger_.lay(place, starts.back());
    }
    return solved(starts, widest_);
  }

  /// Fills the frame in any way; returns `other` where that fails.
  Arrangement covering_or(Arrangement other) const {
    if (arranger_.whole(other)) return other;
    const auto poses = frame_covering(pieces_, matches_, scale_, [&] { report_laying(0); });
    if (!poses) return other;
    Arrangement all = empty_frame();
    all.used.assign(pieces_.size(), true);
    for (std::size_t i = 0; i < poses->size(); ++i) all.laid.push_back({int(i), poses->at(i)});
    arranger_.settle_all(all);
    return arranger_.whole(all) ? all : other;
  }

  /// Moves pieces of one outline to where their pictures agree best. Returns how many might as well lie elsewhere.
  int exchange_alike(Arrangement& in) const {
    const std::size_t first = arranger_.is_frame(in.laid.front()) ? 1 : 0;
    const std::vector<PosedPiece> all = arranger_.laid_pieces(in);
    const ExchangedPieces now = exchanged({all.begin() + std::ptrdiff_t(first), all.end()}, scale_,
                                          [&] { report_laying(arranger_.placed(in)); });
    bool moved = false;
    for (std::size_t i = first; i < in.laid.size(); ++i) {
      moved = moved || !(in.laid[i].pose == now.poses[i - first]);
      in.laid[i].pose = now.poses[i - first];
    }
    if (moved) arranger_.settle_all(in);
    return now.undecided;
  }

  bool is_full(const Arrangement& in) const {
    if (frame_ < 0 || arranger_.gaps(in) > kMostPuzzleGaps) return false;
    double area = 0;
    for (const LaidPiece& laid : in.laid) area += arranger_.is_frame(laid) ? 0 : pieces_[std::size_t(laid.piece)].area;
    return area >= -kFull * pieces_[std::size_t(frame_)].area;
  }

  Solved solution_of(Arrangement best) const {
    Solved solved;
    PuzzleSolution& solution = solved.solution;
    solution.undecided = exchange_alike(best);
    if (frame_ >= 0) keep_within_frame(best, arranger_);
    solution.poses.resize(arranger_.pieces_count());
    for (const LaidPiece& laid : best.laid) {
      if (!arranger_.is_frame(laid)) solution.poses[std::size_t(laid.piece)] = laid.pose;
    }
    solution.placed = int(arranger_.placed(best));
    solution.scale = times_;
    solution.gaps = arranger_.gaps(best);
    solved.done = arranger_.whole(best) || is_full(best);
    solved.coherence = arranger_.coherence(best);
    return solved;
  }

  std::function<void(std::size_t)> report_matching() const {
    return [this](std::size_t piece) { watch_({.laying = false, .done = piece, .of = pieces_.size()}); };
  }

  /// Reports the present arrangement.
  void report_laying(std::size_t laid) const { watch_({.laying = true, .done = laid, .of = arranger_.pieces_count()}); }

  const int widest_;  // arrangements that are followed at a time at most
  PuzzleScale scale_;
  const std::function<void(const PuzzleProgress&)>& watch_;
  std::vector<PuzzlePiece> pieces_;
  const int frame_;   // index of the frame; -1: none
  double times_ = 1;  // PuzzleSolution::scale
  std::vector<std::vector<PieceMatch>> matches_;
  PuzzleArranger arranger_;
};

/// The factor by which growing makes the pieces longer: the ratio of the square roots of their areas.
double times_grown(const std::vector<std::vector<Vec2>>& before, const std::vector<std::vector<Vec2>>& after) {
  double area_before = 0, area_after = 0;
  for (const std::vector<Vec2>& polygon : before) area_before += signed_area(polygon);
  for (const std::vector<Vec2>& polygon : after) area_after += signed_area(polygon);
  return std::sqrt(area_after / area_before);
}

/// Solves with grown pieces. A frame that was made as large as all pieces grows with them.
Solved solved_grown(const PuzzleInput& input, float erosion, int widest) {
  PuzzleInput grown = input;
  for (std::vector<Vec2>& polygon : grown.pieces) polygon = grown_polygon(polygon, erosion);
  const double times = input.frame_fits || input.frame.empty() ? 1 : times_grown(input.pieces, grown.pieces);
  for (Vec2& p : grown.frame) p = p * float(times);
  Solved solved = Solver(grown, widest).solve(grown);
  solved.solution.scale /= times;
  solved.solution.erosion = erosion;
  return solved;
}

}  // namespace

PuzzleSolution solve_puzzle(const PuzzleInput& input) {
  if (input.pieces.empty()) return {};
  const double frame_area = input.frame_fits && !input.frame.empty() ? signed_area(input.frame) : 0;
  const std::vector<float> erosions = likely_erosions(input.pieces, frame_area, scale_of(input.pieces), [&] {
    input.watch({.laying = false, .done = 0, .of = input.pieces.size()});
  });
  if (erosions.size() == 1) return solved_grown(input, erosions.front(), kWidest).solution;
  std::optional<Solved> best;
  for (const int widest : kWidestInTurn) {
    for (const float erosion : erosions) {
      Solved solved = solved_grown(input, erosion, widest);
      if (solved.done) return solved.solution;
      if (!best || solved.coherence > best->coherence) best = std::move(solved);
    }
  }
  const Solved last = solved_grown(input, float(best->solution.erosion), kWidest);
  return last.done || last.coherence > best->coherence ? last.solution : best->solution;
}

}  // namespace tessera
