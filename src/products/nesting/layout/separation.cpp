#include "products/nesting/layout/separation.h"

#include <algorithm>

#include "products/nesting/layout/place_search.h"

namespace tessera {
namespace {

/// A pass gains where the overlap falls below this part of the former one.
constexpr double kGain = 0.98;

std::vector<int> overlapping(const NestScene& scene, NestRandom& random) {
  std::vector<int> pieces;
  for (int i = 0; i < scene.size(); ++i) {
    if (scene.overlap_of(i) > 0) pieces.push_back(i);
  }
  for (int i = int(pieces.size()); i > 1; --i)
    std::swap(pieces[std::size_t(i - 1)], pieces[std::size_t(random.below(i))]);
  return pieces;
}

/// Moves every overlapping piece to a place where it overlaps less.
void move_all_once(NestScene& scene, NestRandom& random) {
  for (const int piece : overlapping(scene, random)) {
    scene.check_stop();
    const double before = scene.weighted_overlap_of(piece);
    if (!(before > 0)) continue;
    const NestPlace place = best_place(scene, piece, random);
    if (place.cost < before) scene.move(piece, place.pose);
  }
}

}  // namespace

bool separate(NestScene& scene, const SeparationLimits& limits, NestRandom& random) {
  double least = scene.overlap();
  std::vector<NestPose> best = scene.poses();
  if (!(least > 0)) return true;
  for (int strikes = 0; strikes < limits.strikes && scene.work() < limits.most_work;) {
    const double at_first = least;
    for (int idle = 0; idle < limits.patience && scene.work() < limits.most_work; ++idle) {
      move_all_once(scene, random);
      const double overlap = scene.overlap();
      if (!(overlap > 0)) return true;
      if (overlap < least) {
        if (overlap < kGain * least) idle = 0;
        least = overlap;
        best = scene.poses();
      }
      scene.grow_weights();
    }
    strikes = least < kGain * at_first ? 0 : strikes + 1;
    scene.restore(best);
  }
  return false;
}

}  // namespace tessera
