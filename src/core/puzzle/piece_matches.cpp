#include "core/puzzle/piece_matches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/puzzle/puzzle_contact.h"

namespace tessera {
namespace {

/// Steps from the corner that a first alignment goes by, unless a side ends before.
constexpr float kFirstSteps = 20;
/// Steps that must run alike.
constexpr int kLeastSteps = 6;
/// Corners are round: the points next to them say nothing.
constexpr int kRound = 2;
/// Steps by which sides of one length may differ.
constexpr float kSameLength = 1;
/// Of each corner and side so many of the longest are held against the outlines.
constexpr std::size_t kMostTried = 24;

struct Alignment {
  Similarity here_from_there;
  float rms = 0;
};

/// Least squares of there[k] on here[k], k from kRound to last.
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

/// The chords from the corner, which no turn changes: a cheap first look.
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

/// As far as both run alike; 0 steps: they do not.
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

struct Found {
  int piece;
  Run run;
  bool whole_side;
};

void keep_best(std::vector<Found>& found) {
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.whole_side != b.whole_side ? a.whole_side : a.run.steps > b.run.steps;
  });
  if (found.size() > kMostTried) found.resize(kMostTried);
}

}  // namespace

std::vector<std::vector<PieceMatch>> piece_matches(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale) {
  std::vector<std::vector<PieceMatch>> matches(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const PuzzleCorner& here : pieces[i].corners) {
      std::vector<Found> found;
      for (std::size_t j = 0; j < pieces.size(); ++j) {
        if (j == i) continue;
        for (const PuzzleCorner& there : pieces[j].corners) {
          const std::size_t last = std::min(here.ahead.size(), there.back.size()) - 1;  // of a speck that is near
          const int first = std::min(int(std::min({kFirstSteps, here.side_ahead, there.side_back})), int(last));
          if (first < kLeastSteps || !chords_agree(here.ahead, there.back, first, 1.5f * scale.tolerance)) continue;
          const Run run = run_alike(here.ahead, there.back, first, scale.tolerance);
          const bool whole_side = pieces[i].area > 0 && pieces[j].area > 0
                                      ? std::abs(here.side_ahead - there.side_back) < kSameLength
                                      : fills(here, there, run.alignment.here_from_there, scale);
          if (run.steps > 0) found.push_back({int(j), run, whole_side});
        }
      }
      keep_best(found);
      for (const Found& f : found) {
        const PosedPiece standing{&pieces[i], {}},
            other{&pieces[std::size_t(f.piece)], f.run.alignment.here_from_there};
        if (overlap(other, standing, scale)) continue;
        const float length = float(f.run.steps) * scale.step;
        matches[i].push_back({f.piece, other.pose, length, f.whole_side});
        matches[std::size_t(f.piece)].push_back({int(i), rigid_inverse(other.pose), length, f.whole_side});
      }
    }
  }
  return matches;
}

}  // namespace tessera
