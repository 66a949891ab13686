#include "products/puzzle/pieces/piece_matches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/stop.h"
#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {
namespace {

/// Steps from the corner for the first alignment, unless a side ends before.
constexpr float kFirstSteps = 20;
/// Steps that must agree.
constexpr int kLeastSteps = 6;
/// Corners are round, so the points next to them are ignored.
constexpr int kRound = 2;
/// Difference, in steps, of sides that count as equally long.
constexpr float kSameLength = 1;
/// The number of the longest matches of each corner and side that are compared with the outlines.
constexpr std::size_t kMostTried = 24;
/// Usually all of them where there are few pieces, so that no arrangement is missed.
constexpr std::size_t kMostTriedOfFew = 96;
constexpr std::size_t kFewPieces = 25;

struct Alignment {
  Similarity here_from_there;
  float rms = 0;
};

/// Least squares of there[k] on here[k], k from kRound to `last`.
Alignment aligned(const std::vector<Vec2>& here, const std::vector<Vec2>& there, int last) {
  double hx = 0, hy = 0, tx = 0, ty = 0;
  const int n = last - kRound + 1;
  for (int k = kRound; k <= last; ++k) {
    hx += here[std::size_t(k)].x;
    hy += here[std::size_t(k)].y;
    tx += there[std::size_t(k)].x;
    ty += there[std::size_t(k)].y;
  }
  const Vec2 h{float(hx / n), float(hy / n)}, t{float(tx / n), float(ty / n)};
  double a = 0, b = 0;
  for (int k = kRound; k <= last; ++k) {
    const Vec2 p = there[std::size_t(k)] - t, q = here[std::size_t(k)] - h;
    a += dot(p, q);
    b += cross(p, q);
  }
  const double length = std::max(std::sqrt(a * a + b * b), 1e-30);
  Alignment result{.here_from_there = {float(a / length), float(b / length), 0, 0}};
  const Vec2 at = h - result.here_from_there.apply(t);
  result.here_from_there.tx = at.x;
  result.here_from_there.ty = at.y;
  double squares = 0;
  for (int k = kRound; k <= last; ++k) {
    const Vec2 off = result.here_from_there.apply(there[std::size_t(k)]) - here[std::size_t(k)];
    squares += dot(off, off);
  }
  result.rms = float(std::sqrt(squares / n));
  return result;
}

/// Compares the chords from the corner, which no turn changes: a cheap first test.
bool chords_agree(const std::vector<Vec2>& here, const std::vector<Vec2>& there, int last, float tolerance) {
  for (const int k : {last / 2, last}) {
    const float a = norm(here[std::size_t(k)] - here[0]), b = norm(there[std::size_t(k)] - there[0]);
    if (std::abs(a - b) > tolerance) return false;
  }
  return true;
}

struct Run {
  Alignment alignment;
  int steps = 0;
};

/// Follows both boundaries as far as they agree; 0 steps: they do not.
Run run_alike(const std::vector<Vec2>& here, const std::vector<Vec2>& there, int first, float tolerance) {
  const int longest = int(std::min(here.size(), there.size())) - 1;
  Run run{aligned(here, there, first), first};
  if (run.alignment.rms > tolerance) return {};
  while (run.steps < longest) {
    const int next = std::min(longest, run.steps + std::max(4, run.steps / 4));
    const Alignment longer = aligned(here, there, next);
    const Vec2 off = longer.here_from_there.apply(there[std::size_t(next)]) - here[std::size_t(next)];
    if (longer.rms > tolerance || norm(off) > 2 * tolerance) break;
    run = {longer, next};
  }
  return run;
}

/// Whether a piece's corner fills one of the frame: its other side runs along the frame, too.
bool fills(const PuzzleCorner& here, const PuzzleCorner& there, const Similarity& here_from_there,
           const PuzzleScale& scale) {
  const Vec2 off = here_from_there.apply(there.ahead[kLeastSteps]) - here.back[kLeastSteps];
  return norm(off) < 2 * scale.tolerance;
}

/// Lengths count more by this factor where the pictures agree, and less where they do not.
constexpr float kPictureShare = 0.5f;
/// Lengths count less by this factor where boundaries are as far apart as tolerated: small foreign pieces are.
constexpr float kApartShare = 0.7f;

struct Found {
  int piece;
  Run run;
  bool whole_side;
  float steps;  // of the run, with the agreement of the pictures
  float close;  // the same, reduced by the distance of the boundaries
};

/// The mean agreement of the pictures along the run.
float pictures_agree(const PuzzlePiece& here, const PuzzleCorner& ahead, const PuzzlePiece& there,
                     const PuzzleCorner& back, int steps, const PuzzleScale& scale) {
  if (scale.contrast <= 0) return 0;
  const auto outside = [](const std::vector<Vec2>& profile, int k, float sign) {
    const Vec2 along = profile[std::size_t(k + 1)] - profile[std::size_t(k - 1)];
    return Vec2{along.y, -along.x} * (sign / std::max(norm(along), 1e-20f));
  };
  float sum = 0;
  for (int k = kRound; k < steps; ++k) {
    sum += pictures_agree(here, ahead.ahead[std::size_t(k)], outside(ahead.ahead, k, 1), there,
                          back.back[std::size_t(k)], outside(back.back, k, -1), scale);
  }
  return sum / float(std::max(1, steps - kRound));
}

void keep_best(std::vector<Found>& found, std::size_t most) {
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.whole_side != b.whole_side ? a.whole_side : a.close > b.close;
  });
  if (found.size() > most) found.resize(most);
}

using Matches = std::vector<std::vector<PieceMatch>>;

/// Adds the matches from corner `c` of piece `i` ahead, with the pieces from `first` on.
void add_matches(const std::vector<PuzzlePiece>& pieces, std::size_t i, std::size_t c, std::size_t first,
                 const PuzzleScale& scale, Matches& matches) {
  const PuzzleCorner& here = pieces[i].corners[c];
  std::vector<Found> found;
  for (std::size_t j = first; j < pieces.size(); ++j) {
    if (j == i) continue;
    for (const PuzzleCorner& there : pieces[j].corners) {
      const std::size_t last = std::min(here.ahead.size(), there.back.size()) - 1;  // few for a speck
      const int steps = std::min(int(std::min({kFirstSteps, here.side_ahead, there.side_back})), int(last));
      if (steps < kLeastSteps || !chords_agree(here.ahead, there.back, steps, 1.5f * scale.tolerance)) continue;
      const Run run = run_alike(here.ahead, there.back, steps, scale.tolerance);
      const bool whole_side = pieces[i].area > 0 && pieces[j].area > 0
                                  ? std::abs(here.side_ahead - there.side_back) < kSameLength
                                  : fills(here, there, run.alignment.here_from_there, scale);
      if (run.steps == 0) continue;
      const float agreement = pictures_agree(pieces[i], here, pieces[j], there, run.steps, scale);
      const float alike = float(run.steps) * (1 + kPictureShare * agreement);
      const float close = alike * (1 - kApartShare * run.alignment.rms / scale.tolerance);
      found.push_back({int(j), run, whole_side, alike, close});
    }
  }
  keep_best(found, pieces.size() > kFewPieces ? kMostTried : kMostTriedOfFew);
  for (const Found& f : found) {
    const PosedPiece standing{&pieces[i], {}}, other{&pieces[std::size_t(f.piece)], f.run.alignment.here_from_there};
    if (overlap(other, standing, scale)) continue;
    const float worth = f.steps * scale.step;
    const float apart = f.run.alignment.rms / scale.tolerance;
    matches[i].push_back({f.piece, other.pose, worth, f.whole_side, int(c), apart});
    matches[std::size_t(f.piece)].push_back({int(i), rigid_inverse(other.pose), worth, f.whole_side, -1, apart});
  }
}

}  // namespace

Matches piece_matches(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale,
                      const std::function<void(std::size_t)>& watch) {
  Matches matches(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t c = 0; c < pieces[i].corners.size(); ++c) {
      watch(i);
      add_matches(pieces, i, c, 0, scale, matches);
    }
  }
  return matches;
}

std::vector<SideMatch> sampled_sides(const std::vector<PuzzlePiece>& pieces, std::size_t sample,
                                     const PuzzleScale& scale, const StopCheck& check_stop) {
  const std::size_t count = std::min(sample, pieces.size());
  Matches matches(pieces.size());
  std::vector<SideMatch> sides;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * pieces.size() / count;
    for (std::size_t c = 0; c < pieces[i].corners.size(); ++c) {
      check_stop();
      matches[i].clear();
      add_matches(pieces, i, c, 0, scale, matches);
      SideMatch longest{int(i), {}};
      for (const PieceMatch& match : matches[i]) {
        const SideMatch side{int(i), match};
        if (match.whole_side && side.length() > longest.length()) longest = side;
      }
      if (longest.length() > 0) sides.push_back(longest);
    }
  }
  return sides;
}

void match_frame_anew(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale, Matches& matches,
                      const std::function<void(std::size_t)>& watch) {
  const std::size_t frame = pieces.size() - 1;
  matches[frame].clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::erase_if(matches[i], [&](const PieceMatch& match) { return match.piece == int(frame); });
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t c = 0; c < pieces[i].corners.size(); ++c) {
      watch(i);
      add_matches(pieces, i, c, i == frame ? 0 : frame, scale, matches);
    }
  }
}

}  // namespace tessera
