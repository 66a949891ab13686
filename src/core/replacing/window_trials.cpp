#include "core/replacing/window_trials.h"

#include <algorithm>
#include <cstddef>

#include "core/base/portable_math.h"
#include "core/base/stop.h"
#include "core/replacing/draws.h"
#include "core/replacing/hole_candidates.h"
#include "core/replacing/repetition.h"
#include "core/replacing/scene.h"

namespace tessera {
namespace {

constexpr std::size_t kMostPointsDrawn = 8;  // the most open of the drawn points is the hole's centre
constexpr float kPieceSearchReach =
    1.6f;                          // of the most scale: distance from the centre up to which pieces are considered
constexpr float kRing = 0.4f;      // of the middle size: pieces nearer than this to pieces that go out make room
constexpr float kRoundCentre = 1;  // of the middle size: so do pieces nearer than this to the hole's centre
// of the product of both scales: rise of the energy after soft sweeps that ends a trial
constexpr float kGiveUp = 1.6f;
constexpr float kSoftness = 1.5f;  // cost for a candidate, px² per px² of overlap with others, times 0.6 to 1.4
// Distance from a hole's centre to its end, px: as far as the pieces that go out and a little more. If none goes out,
// it follows from the sizes.
constexpr float kBeyondOut_px = 10;
constexpr float kLeastReach_px = 30;
constexpr float kMostReach = 2.2f;  // of the most scale
constexpr float kBeyondReach_px = 15;

/// The number of pieces that go out: mostly one.
std::size_t drawn_count(Draws& draws) {
  const float u = draws.unit();
  return u < 0.05f ? 0 : u < 0.85f ? 1 : u < 0.96f ? 2 : 3;
}

/// New pieces in the hole, and the room made for them.
struct Attempt {
  Scene scene;
  std::vector<HoleCandidate> incoming;  // the scene's last pieces, at their first poses
  double energy_px2 = 0;
};

struct Trial {
  Vec2 centre_px;
  float reach_px = 0;
  std::vector<std::size_t> out;   // pieces that go out
  std::vector<std::size_t> ring;  // pieces that make room
};

class WindowTrials {
 public:
  WindowTrials(const ReplacementWindow& window, const HoleShapes& shapes, TaskPool& pool)
      : window_(window),
        shapes_(shapes),
        pool_(pool),
        relaxation_(window),
        pieces_(window, shapes, relaxation_.edge()),
        repetition_(window),
        draws_(window.random),
        middle_px_(middle_px(window)) {}

  ReplacementOutcome run(const StopCheck& check_stop) {
    ReplacementOutcome outcome;
    for (std::uint32_t k = 0; k < window_.trials; ++k) {
      check_stop();
      const float progress = float(k) / float(window_.trials);
      temperature_px2_ =
          window_.first_temperature_px2 + (window_.last_temperature_px2 - window_.first_temperature_px2) * progress;
      outcome.kept += try_once();
    }
    outcome.pieces = pieces_.replaced();
    return outcome;
  }

 private:
  Vec2 drawn_centre() {
    const std::size_t points = 1 + draws_.below(kMostPointsDrawn);
    Vec2 centre;
    float most = 0;
    for (std::size_t k = 0; k < points; ++k) {
      const float x = draws_.unit();
      const float y = draws_.unit();
      const Vec2 p = window_.box.low + Vec2{x * window_.box.width(), y * window_.box.height()};
      const float open = pieces_.openness_px(p, middle_px_);
      if (k > 0 && open <= most) continue;
      centre = p;
      most = open;
    }
    return centre;
  }

  /// The hole's reach: as far as the pieces that go out; if there are none, as far as a small piece may need.
  float reach_px(Vec2 centre_px, const std::vector<std::size_t>& out) const {
    if (out.empty()) return std::max(2.5f * window_.least_scale_px, std::min(60.f, 0.6f * window_.most_scale_px));
    const float needed_px = std::max(pieces_.farthest_px(centre_px, out) + kBeyondOut_px, kLeastReach_px);
    return std::min(needed_px, kMostReach * window_.most_scale_px);
  }

  bool draw(Trial& trial) {
    trial.centre_px = drawn_centre();
    const std::size_t wanted = drawn_count(draws_);
    const auto near = pieces_.nearest(trial.centre_px, kPieceSearchReach * window_.most_scale_px);
    for (const auto& [distance_px, i] : near) {
      if (trial.out.size() < wanted && pieces_.may_move(i)) trial.out.push_back(i);
    }
    if (trial.out.size() < wanted) return false;
    for (const auto& [distance_px, i] : near) {
      const bool goes = std::find(trial.out.begin(), trial.out.end(), i) != trial.out.end();
      if (goes || !pieces_.may_move(i)) continue;
      if (distance_px < kRoundCentre * middle_px_ || pieces_.any_near(i, trial.out, kRing * middle_px_)) {
        trial.ring.push_back(i);
      }
    }
    trial.reach_px = reach_px(trial.centre_px, trial.out);
    return true;
  }

  bool try_once() {
    Trial trial;
    if (!draw(trial)) return false;
    std::vector<std::size_t> before = trial.ring;
    before.insert(before.end(), trial.out.begin(), trial.out.end());
    const double old_energy_px2 = relaxation_.energy_px2(pieces_.scene_of(before, {}, {})) + repetition_.energy_px2();
    const Attempt best = best_attempt(trial, old_energy_px2);
    if (best.incoming.empty() || !accepts(best.energy_px2 - old_energy_px2) || !pieces_.stays_inside(best.scene)) {
      return false;
    }
    take(best, trial);
    return true;
  }

  PlacedDrawing standing(std::size_t i) const {
    return placed_drawing(pieces_[i].piece.drawing, pieces_[i].piece.canvas_from_shape);
  }

  Repetition without(const std::vector<std::size_t>& out) const {
    Repetition left = repetition_;
    for (const std::size_t i : out) left.remove(standing(i));
    return left;
  }

  /// The repetition of all pieces when the trial's pieces lie as in the scene.
  Repetition repetition_of(const Attempt& attempt, const Trial& trial) const {
    Repetition now = without(trial.out);
    for (std::size_t k = 0; k < trial.ring.size(); ++k) {
      now.remove(standing(trial.ring[k]));
      now.add(placed_drawing(pieces_[trial.ring[k]].piece.drawing, attempt.scene.pieces[k].canvas_from_shape));
    }
    const std::size_t old = attempt.scene.pieces.size() - attempt.incoming.size();
    for (std::size_t k = 0; k < attempt.incoming.size(); ++k) {
      now.add(placed_drawing(incoming(attempt.incoming[k]).drawing, attempt.scene.pieces[old + k].canvas_from_shape));
    }
    return now;
  }

  double energy_px2(const Attempt& attempt, const Trial& trial) const {
    return relaxation_.energy_px2(attempt.scene) + repetition_of(attempt, trial).energy_px2();
  }

  Attempt best_attempt(const Trial& trial, double old_energy_px2) {
    const Hole hole = pieces_.hole_of(trial.centre_px, trial.out, trial.reach_px + kBeyondReach_px);
    const float softness = kSoftness * (0.6f + 0.8f * draws_.unit());
    const std::vector<HoleCandidate> candidates =
        best_candidates(hole, trial.reach_px, guests(without(trial.out), trial), softness, draws_, pool_);
    if (candidates.empty()) return {};
    const std::uint64_t key = draws_.bits();
    std::vector<Attempt> attempts(candidates.size());
    pool_.run(candidates.size(),
              [&](std::size_t i) { attempts[i] = attempt(trial, hole, softness, candidates[i], Draws(key + i)); });
    Attempt& best = *std::min_element(attempts.begin(), attempts.end(),
                                      [](const Attempt& a, const Attempt& b) { return a.energy_px2 < b.energy_px2; });
    const double most_px2 = old_energy_px2 + double(kGiveUp * window_.least_scale_px * window_.most_scale_px);
    if (best.energy_px2 > most_px2) return {};
    relaxation_.relax_fully(best.scene);
    best.energy_px2 = energy_px2(best, trial);
    return std::move(best);
  }

  /// Puts the candidate into the hole, adds pieces until as many came in as went out, and makes room for them.
  Attempt attempt(const Trial& trial, Hole hole, float softness, const HoleCandidate& first, Draws draws) const {
    Attempt made;
    Repetition repetition = without(trial.out);
    add(first, repetition, made);
    while (made.incoming.size() < trial.out.size()) {
      hole.add(laid(made.incoming.back()));
      const auto more = best_candidates(hole, trial.reach_px, guests(repetition, trial), softness, draws, pool_);
      if (more.empty()) break;
      add(more.front(), repetition, made);
    }
    made.scene = scene_of(trial, made.incoming);
    relaxation_.relax_softly(made.scene);
    made.energy_px2 = energy_px2(made, trial);
    return made;
  }

  /// The guests in the order of the window's incoming shapes. As copies they cost what one about as large as the hole
  /// would.
  std::vector<CandidateShape> guests(const Repetition& repetition, const Trial& trial) const {
    const float scale_px = std::min(trial.reach_px, window_.most_scale_px);
    std::vector<CandidateShape> all;
    for (const IncomingShape& in : window_.incoming) {
      const double cost = repetition.cost_px2({in.drawing, trial.centre_px, scale_px}) / double(scale_px * scale_px);
      all.push_back({shapes_.at(in.shape), in.poses, in.weight, float(1 - cost)});
    }
    return all;
  }

  const IncomingShape& incoming(const HoleCandidate& candidate) const { return window_.incoming[candidate.incoming]; }

  void add(const HoleCandidate& candidate, Repetition& repetition, Attempt& attempt) const {
    attempt.incoming.push_back(candidate);
    repetition.add(placed_drawing(incoming(candidate).drawing, candidate.canvas_from_shape));
  }

  ContactPiece laid(const HoleCandidate& candidate) const {
    ContactPiece piece;
    piece.lay(shapes_.at(incoming(candidate).shape)->contact, candidate.canvas_from_shape);
    return piece;
  }

  Scene scene_of(const Trial& trial, const std::vector<HoleCandidate>& coming) const {
    std::vector<Box> boxes;
    for (const HoleCandidate& in : coming) boxes.push_back(laid(in).box);
    Scene scene = pieces_.scene_of(trial.ring, trial.out, boxes);
    for (const HoleCandidate& in : coming) {
      scene.add(*shapes_.at(incoming(in).shape), in.canvas_from_shape, incoming(in).poses, true);
    }
    return scene;
  }

  bool accepts(double change_px2) {
    const float u = draws_.unit();
    if (change_px2 < 0) return true;
    if (!(temperature_px2_ > 0)) return false;
    constexpr float kLog2E = 1.4426950f;
    const float halvings = kLog2E * float(change_px2) / temperature_px2_;
    return halvings < 60 && u < portable_exp2(-halvings);
  }

  void take(const Attempt& attempt, const Trial& trial) {
    repetition_ = repetition_of(attempt, trial);
    for (std::size_t k = 0; k < trial.ring.size(); ++k) {
      pieces_.move(trial.ring[k], attempt.scene.pieces[k].canvas_from_shape);
    }
    pieces_.take_out(trial.out);
    const std::size_t old = attempt.scene.pieces.size() - attempt.incoming.size();
    for (std::size_t k = 0; k < attempt.incoming.size(); ++k) {
      pieces_.add(incoming(attempt.incoming[k]), attempt.scene.pieces[old + k].canvas_from_shape);
    }
  }

  const ReplacementWindow& window_;
  const HoleShapes& shapes_;
  TaskPool& pool_;
  SceneRelaxation relaxation_;
  WindowPieces pieces_;
  Repetition repetition_;
  Draws draws_;
  float middle_px_;
  float temperature_px2_ = 0;
};

}  // namespace

ReplacementOutcome replaced(const ReplacementWindow& window, const HoleShapes& shapes, const StopCheck& check_stop,
                            TaskPool& pool) {
  return WindowTrials(window, shapes, pool).run(check_stop);
}

}  // namespace tessera
