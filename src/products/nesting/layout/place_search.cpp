#include "products/nesting/layout/place_search.h"

#include <algorithm>
#include <limits>

#include "products/nesting/layout/nest_tuning.h"

namespace tessera {
namespace {

using namespace nest_tuning;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The piece that is searched a place: a new one, or one on the strip.
struct Searched {
  int item;
  int piece;  // -1: new
};

NestPoint clamped(const NestBox& free, NestPoint p) {
  return {std::max(free.low.x, std::min(p.x, free.high.x)), std::max(free.low.y, std::min(p.y, free.high.y))};
}

/// The best few places so far, no two of them near each other.
class Finalists {
 public:
  double worst() const { return int(places_.size()) < kDescents ? kInfinity : places_.back().cost; }

  void offer(const NestPlace& place, double apart) {
    for (NestPlace& there : places_) {
      if (there.pose.angle != place.pose.angle || norm(there.pose.shift - place.pose.shift) > apart) continue;
      if (place.cost < there.cost) there = place;
      sort();
      return;
    }
    places_.push_back(place);
    sort();
    if (int(places_.size()) > kDescents) places_.pop_back();
  }

  const std::vector<NestPlace>& places() const { return places_; }

 private:
  void sort() {
    std::stable_sort(places_.begin(), places_.end(),
                     [](const NestPlace& a, const NestPlace& b) { return a.cost < b.cost; });
  }

  std::vector<NestPlace> places_;
};

double smaller_side(const PosedShape& shape) { return std::min(shape.own_box.width(), shape.own_box.height()); }

class Search {
 public:
  Search(NestScene& scene, Searched searched, NestRandom& random)
      : scene_(scene),
        searched_(searched),
        random_(random) {
    for (int angle = 0; angle < scene.angles_of(searched.item); ++angle) {
      if (scene.fits(scene.shape(searched.item, angle))) angles_.push_back(angle);
    }
  }

  bool possible() const { return !angles_.empty(); }

  void try_pose(NestPose pose) {
    const PosedShape& shape = scene_.shape(searched_.item, pose.angle);
    const double worst = finalists_.worst();
    const double cost = scene_.cost(searched_.item, searched_.piece, pose, worst);
    if (cost < worst) finalists_.offer({pose, cost}, kFirstStep * smaller_side(shape));
  }

  void anywhere() {
    const int angle = any_angle();
    const NestBox free = scene_.range(scene_.shape(searched_.item, angle));
    try_pose({angle, {random_.between(free.low.x, free.high.x), random_.between(free.low.y, free.high.y)}});
  }

  void round(const NestBox& box) {
    const int angle = any_angle();
    const PosedShape& shape = scene_.shape(searched_.item, angle);
    const NestPoint low = shape.own_box.low;
    const double x = box.low.x + box.width() * random_.between(-1, 1),
                 y = box.low.y + box.height() * random_.between(-1, 1);
    try_pose({angle, clamped(scene_.range(shape), {x - low.x, y - low.y})});
  }

  /// Tries a place at an edge, beside the box of another piece, or level with it; in x and y.
  void flush() {
    const int angle = any_angle();
    const PosedShape& shape = scene_.shape(searched_.item, angle);
    const NestBox free = scene_.range(shape);
    const int at_x = random_.below(scene_.size() + 1),
              at_y = random_.below(4) == 0 ? random_.below(scene_.size() + 1) : at_x;
    const double x = level(shape.own_box.low.x, shape.own_box.high.x, free.low.x, free.high.x, at_x, true);
    const double y = level(shape.own_box.low.y, shape.own_box.high.y, free.low.y, free.high.y, at_y, false);
    try_pose({angle, clamped(free, {x, y})});
  }

  NestPlace best() {
    NestPlace best{{}, kInfinity};
    for (const NestPlace& place : finalists_.places()) {
      const NestPlace lower = descended(place, kFirstStep, kCoarseStep);
      if (lower.cost < best.cost) best = lower;
    }
    return best.cost > 0 ? descended(best, kCoarseStep, kFineStep) : best;
  }

 private:
  int any_angle() { return angles_[std::size_t(random_.below(int(angles_.size())))]; }

  double level(double low, double high, double first, double last, int other, bool in_x) {
    const int side = random_.below(4);
    if (other == scene_.size() || other == searched_.piece) return side % 2 == 0 ? first : last;
    const NestBox box = scene_.own_box(other);
    const double box_low = in_x ? box.low.x : box.low.y, box_high = in_x ? box.high.x : box.high.y;
    switch (side) {
      case 0: return box_high + scene_.spacing() - low;
      case 1: return box_low - scene_.spacing() - high;
      case 2: return box_low - low;
      default: return box_high - high;
    }
  }

  /// Descends in steps along one of four lines; steps become longer after a gain and shorter without one.
  NestPlace descended(NestPlace place, double first, double last) {
    constexpr double kLonger = 1.1, kShorter = 0.5, kDiagonal = 0.7071067811865476;
    const PosedShape& shape = scene_.shape(searched_.item, place.pose.angle);
    const NestBox free = scene_.range(shape);
    const double end = last * smaller_side(shape);
    NestPoint step{first * smaller_side(shape), first * smaller_side(shape)};
    while (place.cost > 0 && std::max(step.x, step.y) > end) {
      const int line = random_.below(4);
      const NestPoint way = line == 0   ? NestPoint{step.x, 0}
                            : line == 1 ? NestPoint{0, step.y}
                            : line == 2 ? NestPoint{step.x * kDiagonal, step.y * kDiagonal}
                                        : NestPoint{step.x * kDiagonal, -step.y * kDiagonal};
      const bool gained = stepped(place, free, way) || stepped(place, free, way * -1.0);
      const double factor = gained ? kLonger : kShorter;
      // On a diagonal both steps change, by half as much.
      if (line != 1) step.x *= line == 0 ? factor : (1 + factor) / 2;
      if (line != 0) step.y *= line == 1 ? factor : (1 + factor) / 2;
    }
    return place;
  }

  bool stepped(NestPlace& place, const NestBox& free, NestPoint way) {
    const NestPose pose{place.pose.angle, clamped(free, place.pose.shift + way)};
    if (pose.shift == place.pose.shift) return false;
    const double cost = scene_.cost(searched_.item, searched_.piece, pose, place.cost);
    if (!(cost < place.cost)) return false;
    place = {pose, cost};
    return true;
  }

  NestScene& scene_;
  Searched searched_;
  NestRandom& random_;
  std::vector<int> angles_;
  Finalists finalists_;
};

}  // namespace

NestPlace best_place(NestScene& scene, int piece, NestRandom& random) {
  const NestPlace present{scene.pose(piece), scene.weighted_overlap_of(piece)};
  Search search(scene, {scene.item(piece), piece}, random);
  if (!search.possible()) return present;
  search.try_pose(present.pose);
  const NestBox box = scene.own_box(piece);
  for (int i = 0; i < kNearby; ++i) search.round(box);
  for (int i = 0; i < kFlush; ++i) search.flush();
  for (int i = 0; i < kAnywhere; ++i) search.anywhere();
  const NestPlace best = search.best();
  return best.cost < present.cost ? best : present;
}

bool place_for_new(NestScene& scene, int item, int times, NestRandom& random, NestPlace& place) {
  Search search(scene, {item, -1}, random);
  if (!search.possible()) return false;
  for (int i = 0; i < kFlush * times; ++i) search.flush();
  for (int i = 0; i < kAnywhere * times; ++i) search.anywhere();
  place = search.best();
  return true;
}

}  // namespace tessera
