#include "core/relax/relaxation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/portable_math.h"
#include "core/base/stop.h"
#include "core/relax/contacts.h"
#include "core/relax/piece_neighbours.h"
#include "core/relax/relaxation_step.h"

namespace tessera {
namespace {

/// The canvas' edge is stiffer than a neighbour: it does not give way, and what lies outside is lost.
constexpr float kEdgeStiffness = 2;
/// The energy of a contact between pieces is counted in both directions; each direction has this part.
constexpr float kOneWay = 0.5f;
/// Damping, as part of the stiffness of a whole boundary in contact. It keeps pieces without contacts from leaping.
constexpr float kStepDamping = 0.01f;
/// The relaxation ends with a sweep in which no piece moves farther than this.
constexpr float kConverged_px = 0.01f;
/// Neighbours are searched this much farther away than contact reaches, and again when two pieces may have come nearer
/// by as much. A larger slack means more boxes to test, a smaller one more searches.
constexpr float kNeighbourSlack_px = 16;

/// The largest movement of a piece's points in a step of 1 px: its shift, and turn and growth at its farthest point.
float most_movement(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active) {
  float radius = 0;
  for (const std::size_t i : active) radius = std::max(radius, pieces[i].shape->radius);
  return 1 + 2 * radius;
}

std::vector<ContactPiece> laid(const std::vector<RelaxedPiece>& pieces) {
  std::vector<ContactPiece> all(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) all[i].lay(*pieces[i].shape, pieces[i].canvas_from_shape);
  return all;
}

PieceNeighbours neighbours_among(const std::vector<ContactPiece>& pieces, const Period& period) {
  std::vector<Box> boxes;
  for (const ContactPiece& piece : pieces) boxes.push_back(piece.box);
  return {boxes, period};
}

/// The present stiffness of contacts.
struct Stiffness {
  float soft;
  float hard;
};

/// Calls add(depth, stiffness) for a contact at this distance, once for each stiffness that acts there.
template <class Add>
void each_depth(float distance_px, const ContactDistances& distances, const Stiffness& stiffness, Add add) {
  add(distances.soft_px - distance_px, stiffness.soft);
  if (stiffness.hard > 0 && distance_px < distances.hard_px) add(distances.hard_px - distance_px, stiffness.hard);
}

/// The part of the piece's energy that depends on its pose, to second order, without its area.
RelaxationStep step_of(const ContactPiece& piece, const std::vector<ContactPiece>& pieces,
                       const std::vector<Neighbour>& neighbours, const EdgeDistance& edge,
                       const ContactDistances& distances, const Stiffness& stiffness) {
  RelaxationStep step(piece.canvas_from_shape);
  const float reach_px = distances.soft_px;
  for (const Neighbour& n : neighbours) {
    const ContactPiece& other = pieces[n.piece];
    each_contact(piece, other, n.offset, reach_px, [&](const Contact& c) {
      each_depth(c.distance_px, distances, stiffness,
                 [&](float depth_px, float k) { step.add_own(c, depth_px, kOneWay * k); });
    });
    each_contact(other, piece, n.offset * -1.f, reach_px, [&](Contact c) {
      c.at = c.at + n.offset;
      each_depth(c.distance_px, distances, stiffness,
                 [&](float depth_px, float k) { step.add_others(c, depth_px, kOneWay * k); });
    });
  }
  each_contact(piece, edge, reach_px, [&](const Contact& c) {
    each_depth(c.distance_px, distances, stiffness,
               [&](float depth_px, float k) { step.add_own(c, depth_px, kEdgeStiffness * k); });
  });
  return step;
}

/// Moves the piece, by at most `most_px`; returns the length of the movement.
float take(const RelaxationStep& step, const PoseRange& poses, float most_px, ContactPiece& piece) {
  const PieceMovement movement = step.solved(piece.canvas_from_shape, poses);
  const float wanted_px = movement.largest();
  const float part = wanted_px > most_px ? most_px / wanted_px : 1.f;
  piece.lay(*piece.shape, moved(piece.canvas_from_shape, movement, part, poses));
  return part * wanted_px;
}

/// The stiffness at `progress` (0..1) of the schedule. Its inverse, the depth in equilibrium, falls evenly.
float stiffness_at(const RelaxationSchedule& s, float progress) {
  return 1 / ((1 - progress) / s.first_stiffness + progress / s.last_stiffness);
}
float step_at(const RelaxationSchedule& s, float progress) {
  return s.first_step_px + (s.last_step_px - s.first_step_px) * progress;
}

/// Another order in each sweep, so that no piece is always the first to grow.
void shuffle(std::vector<std::size_t>& pieces, int sweep) {
  const auto key = [sweep](std::size_t piece) {
    return std::pair(mix_bits(std::uint64_t(sweep) << 32 ^ std::uint64_t(piece)), piece);
  };
  std::sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
}

}  // namespace

void Relaxation::relax(std::vector<RelaxedPiece>& pieces, std::vector<std::size_t> active,
                       const RelaxationSchedule& schedule, const StopCheck& check_stop) const {
  std::erase_if(active, [&](std::size_t i) { return pieces[i].fixed; });
  std::vector<ContactPiece> all = laid(pieces);
  std::vector<std::vector<Neighbour>> neighbours(pieces.size());
  const float movement = most_movement(pieces, active);
  float may_have_moved_px = kNeighbourSlack_px;
  for (int sweep = 0; sweep < schedule.sweeps; ++sweep) {
    check_stop();
    const float progress = schedule.sweeps > 1 ? float(sweep) / float(schedule.sweeps - 1) : 1.f;
    const float stiffness = stiffness_at(schedule, progress);
    const float most_step_px = step_at(schedule, progress);
    // Two pieces may approach each other by twice that.
    if (2 * (may_have_moved_px + movement * most_step_px) > kNeighbourSlack_px) {
      const PieceNeighbours near = neighbours_among(all, edge_.period());
      for (const std::size_t i : active) {
        neighbours[i] = near.of(std::uint32_t(i), distances_.reach_px() + kNeighbourSlack_px);
      }
      may_have_moved_px = 0;
    }
    shuffle(active, sweep);
    float largest_px = 0;
    for (const std::size_t i : active) {
      RelaxationStep step =
          step_of(all[i], all, neighbours[i], edge_, distances_, {stiffness, schedule.hard_stiffness});
      if (schedule.growing) step.add_growth();
      step.add_damping(kStepDamping * stiffness * all[i].shape->perimeter * all[i].scale_px);
      largest_px = std::max(largest_px, take(step, pieces[i].poses, most_step_px, all[i]));
    }
    may_have_moved_px += movement * largest_px;
    if (largest_px < kConverged_px) break;
  }
  for (const std::size_t i : active) {
    pieces[i].canvas_from_shape = edge_.period().wrapped(all[i].canvas_from_shape);
  }
}

double Relaxation::energy_px2(const std::vector<RelaxedPiece>& pieces, float stiffness) const {
  std::vector<std::size_t> all(pieces.size());
  std::iota(all.begin(), all.end(), 0);
  return energy_px2(pieces, all, stiffness);
}

double Relaxation::energy_px2(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& active,
                              float stiffness, float hard_stiffness) const {
  const std::vector<ContactPiece> all = laid(pieces);
  const PieceNeighbours near = neighbours_among(all, edge_.period());
  std::vector<bool> is_active(pieces.size(), false);
  for (const std::size_t i : active) is_active[i] = true;
  double area_px2 = 0;
  double between = 0;  // sums of stiffness times length times depth²
  double outside = 0;
  const auto add_to = [&](double& sum) {
    return [&](const Contact& c) {
      each_depth(c.distance_px, distances_, {stiffness, hard_stiffness},
                 [&](double depth_px, float k) { sum += double(k) * c.length_px * depth_px * depth_px; });
    };
  };
  for (const std::size_t i : active) {
    area_px2 += double(all[i].scale_px) * double(all[i].scale_px);
    for (const Neighbour& n : near.of(std::uint32_t(i), distances_.reach_px())) {
      each_contact(all[i], all[n.piece], n.offset, distances_.soft_px, add_to(between));
      if (is_active[n.piece]) continue;  // the other piece's turn counts these contacts
      each_contact(all[n.piece], all[i], n.offset * -1.f, distances_.soft_px, add_to(between));
    }
    each_contact(all[i], edge_, distances_.soft_px, add_to(outside));
  }
  return 0.5 * (kOneWay * between + kEdgeStiffness * outside) - area_px2;
}

std::array<double, 4> Relaxation::energy_gradient(const std::vector<RelaxedPiece>& pieces, std::size_t piece,
                                                  float stiffness) const {
  const std::vector<ContactPiece> all = laid(pieces);
  const PieceNeighbours near = neighbours_among(all, edge_.period());
  RelaxationStep step =
      step_of(all[piece], all, near.of(std::uint32_t(piece), distances_.reach_px()), edge_, distances_, {stiffness, 0});
  step.add_growth();
  const auto& g = step.gradient();
  return {g[0], g[1], g[2], g[3]};
}

}  // namespace tessera
