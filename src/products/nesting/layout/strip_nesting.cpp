#include "products/nesting/layout/strip_nesting.h"

#include <algorithm>
#include <cmath>

#include "products/nesting/layout/nest_order.h"
#include "products/nesting/layout/nest_tuning.h"
#include "products/nesting/layout/place_search.h"
#include "products/nesting/layout/separation.h"

namespace tessera {
namespace {

using namespace nest_tuning;

struct Layout {
  std::vector<NestPose> poses;
  double overlap = 0;
};

/// Shortens the strip at a random cut: all pieces right of it move left. False where a piece is longer than the strip.
bool shrink(NestScene& scene, double by, NestRandom& random) {
  const double cut = random.between(0, scene.length());
  scene.set_length(scene.length() - by);
  std::vector<NestPose> poses = scene.poses();
  for (int i = 0; i < scene.size(); ++i) {
    const NestBox box = scene.own_box(i);
    if (box.low.x + box.high.x > 2 * cut) poses[std::size_t(i)].shift.x -= by;
  }
  scene.restore(poses);
  return scene.clamp_all();
}

/// Slides the piece left, in steps or by one jump to beside another's box, as far as it meets nothing. Steps grow where the
/// way is many times the piece's width; otherwise a tiny piece on a long strip would take for ever.
bool slid_left(NestScene& scene, int piece) {
  constexpr double kFirst = 0.02, kLast = 1e-6;  // parts of the piece's width
  constexpr int kSmallSteps = 128;
  const PosedShape& shape = scene.shape(piece);
  const double least = scene.range(shape).low.x, start = scene.pose(piece).shift.x;
  const auto goes_to = [&](double x) {
    NestPose pose = scene.pose(piece);
    if (!(x >= least && x < pose.shift.x)) return false;
    pose.shift.x = x;
    if (scene.cost(scene.item(piece), piece, pose, 0) > 0) return false;
    scene.move(piece, pose);
    return true;
  };
  const double width = shape.own_box.width();
  int steps = 0;
  for (double step = kFirst * width; step > kLast * width;) {
    if (!goes_to(scene.pose(piece).shift.x - step))
      step /= 2;
    else if (++steps > kSmallSteps)
      step *= 2;
  }
  // The exact places, which steps only come near to.
  goes_to(least);
  for (int other = 0; other < scene.size(); ++other) {
    if (other != piece) goes_to(scene.own_box(other).high.x + scene.spacing() - shape.own_box.low.x);
  }
  return scene.pose(piece).shift.x < start;
}

/// Slides every piece as far left as the others allow, the leftmost first, a few times, within the budget.
void slide_all_left(NestScene& scene, std::uint64_t most_work) {
  constexpr int kTimes = 3;
  for (int time = 0; time < kTimes; ++time) {
    std::vector<int> order(std::size_t(scene.size()));
    for (int i = 0; i < scene.size(); ++i) order[std::size_t(i)] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return scene.own_box(a).low.x < scene.own_box(b).low.x; });
    bool moved = false;
    for (const int piece : order) {
      if (scene.work() >= most_work) return;
      scene.check_stop();
      moved |= slid_left(scene, piece);
    }
    if (!moved) return;
  }
}

using Shorter = std::function<void(double length)>;

void take(NestScene& scene, Layout& best, std::uint64_t most_work, const Shorter& shorter) {
  slide_all_left(scene, most_work);
  scene.set_length(scene.used_length());
  best = {scene.poses(), 0};
  if (shorter) shorter(scene.length());
}

NestPoint middle(const NestBox& box) { return (box.low + box.high) * 0.5; }

/// Swaps two large pieces of different shapes.
void swap_large_ones(NestScene& scene, NestRandom& random) {
  constexpr double kLargest = 0.5;  // part of the pieces
  std::vector<int> order(std::size_t(scene.size()));
  for (int i = 0; i < scene.size(); ++i) order[std::size_t(i)] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return size_to_place(scene.shape(a)) > size_to_place(scene.shape(b)); });
  const int large = std::max(2, int(kLargest * scene.size()));
  if (scene.size() < 2) return;
  const int a = order[std::size_t(random.below(std::min(large, scene.size())))];
  int b = a;
  for (int tries = 0; tries < 32 && (b == a || scene.item(b) == scene.item(a)); ++tries)
    b = order[std::size_t(random.below(std::min(large, scene.size())))];
  if (b == a) return;
  const std::vector<NestPose> before = scene.poses();
  std::vector<NestPose> poses = before;
  const NestPoint by = middle(scene.own_box(b)) - middle(scene.own_box(a));
  poses[std::size_t(a)].shift = poses[std::size_t(a)].shift + by;
  poses[std::size_t(b)].shift = poses[std::size_t(b)].shift - by;
  scene.restore(poses);
  if (!scene.clamp_all()) scene.restore(before);
}

/// Layouts of one length that could not be separated, the least overlap first.
class Failures {
 public:
  void add(Layout layout) {
    const auto at = std::upper_bound(layouts_.begin(), layouts_.end(), layout,
                                     [](const Layout& a, const Layout& b) { return a.overlap < b.overlap; });
    layouts_.insert(at, std::move(layout));
  }
  void clear() { layouts_.clear(); }
  /// A random layout, more likely one of the first.
  const Layout& any(NestRandom& random) const {
    const double u = random.unit();
    return layouts_[std::size_t(u * u * double(layouts_.size()))];
  }

 private:
  std::vector<Layout> layouts_;
};

void explore(NestScene& scene, Layout& best, std::uint64_t most_work, NestRandom& random, const Shorter& shorter) {
  const SeparationLimits limits{kPassesWithoutGain, kMostRestarts, most_work};
  Failures failures;
  bool possible = shrink(scene, kShrink * scene.length(), random);
  while (possible && scene.work() < most_work) {
    if (separate(scene, limits, random)) {
      take(scene, best, most_work, shorter);
      failures.clear();
      possible = shrink(scene, kShrink * scene.length(), random);
    } else {
      failures.add({scene.poses(), scene.overlap()});
      scene.restore(failures.any(random).poses);
      swap_large_ones(scene, random);
    }
  }
}

void compress(NestScene& scene, Layout& best, double best_length, std::uint64_t most_work, NestRandom& random,
              const Shorter& shorter) {
  const std::uint64_t first = scene.work();
  while (scene.work() < most_work) {
    const double done = double(scene.work() - first) / double(most_work - first);
    scene.set_length(best_length);
    scene.restore(best.poses);
    if (!shrink(scene, best_length * (kFirstCompression + (kLastCompression - kFirstCompression) * done), random))
      return;
    if (!separate(scene, {kPassesWithoutGain / 2, kMostRestarts, most_work}, random)) continue;
    take(scene, best, most_work, shorter);
    best_length = scene.length();
  }
}

}  // namespace

void lay_in_order(NestScene& scene, std::vector<int> items, NestRandom& random,
                  const std::function<void(std::span<const int> left)>& laid) {
  order_by_size(scene, items);
  double length = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int item = items[i];
    scene.check_stop();
    double width = 0;
    for (int angle = 0; angle < scene.angles_of(item); ++angle)
      width = std::max(width, scene.shape(item, angle).own_box.width());
    NestPlace place;
    scene.set_length(std::max(length, width));
    bool found = place_for_new(scene, item, kTimesForNew, random, place) && !(place.cost > 0);
    if (!found) {
      scene.set_length(length + scene.spacing() + width);
      // Beyond all other pieces there is room for some angle; the caller has checked that one fits.
      for (int angle = 0; !found && angle < scene.angles_of(item); ++angle) {
        const PosedShape& shape = scene.shape(item, angle);
        if (!scene.fits(shape)) continue;
        place = {{angle, {length + scene.spacing() - shape.own_box.low.x, scene.range(shape).low.y}}, 0};
        found = true;
      }
    }
    scene.add(item, place.pose);
    length = scene.used_length();
    if (laid) laid(std::span(items).subspan(i + 1));
  }
  scene.set_length(length);
}

void shorten(NestScene& scene, std::uint64_t most_work, NestRandom& random, const Shorter& shorter) {
  most_work = std::max(most_work, scene.work());
  Layout best;
  take(scene, best, most_work, shorter);
  double best_length = scene.length();
  explore(scene, best, scene.work() + std::uint64_t(kExploring * double(most_work - scene.work())), random, shorter);
  scene.restore(best.poses);
  best_length = scene.used_length();
  compress(scene, best, best_length, most_work, random, shorter);
  scene.restore(best.poses);
  scene.set_length(scene.used_length());
}

}  // namespace tessera
