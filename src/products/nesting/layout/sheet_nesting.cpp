#include "products/nesting/layout/sheet_nesting.h"

#include <algorithm>
#include <cmath>

#include "products/nesting/layout/nest_order.h"
#include "products/nesting/layout/nest_tuning.h"
#include "products/nesting/layout/place_search.h"
#include "products/nesting/layout/separation.h"

namespace tessera {
namespace {

/// Lays the pieces that fit without moving others, and returns the rest.
std::vector<int> lay_where_free(NestScene& scene, const std::vector<int>& items, NestRandom& random) {
  std::vector<int> left;
  for (const int item : items) {
    scene.check_stop();
    // If one piece of an item failed, the next one of this item would fail, too.
    NestPlace place;
    const bool free = (left.empty() || left.back() != item) &&
                      place_for_new(scene, item, nest_tuning::kTimesForNew, random, place) && !(place.cost > 0);
    if (free)
      scene.add(item, place.pose);
    else
      left.push_back(item);
  }
  return left;
}

/// Adds the piece where it overlaps least, and separates all pieces.
bool squeeze_in(NestScene& scene, int item, std::uint64_t most_work, NestRandom& random) {
  NestPlace place;
  if (!place_for_new(scene, item, nest_tuning::kTimesForNew, random, place)) return false;
  const std::vector<NestPose> before = scene.poses();
  scene.add(item, place.pose);
  if (separate(scene, {nest_tuning::kSqueezingPatience, 1, most_work}, random)) return true;
  scene.remove_last();
  scene.restore(before);
  return false;
}

double area_left(const NestScene& scene) {
  double area = scene.length() * scene.height();
  for (int i = 0; i < scene.size(); ++i) area -= scene.shape(i).area;
  return area;
}

}  // namespace

std::vector<int> fill_sheet(NestScene& scene, std::vector<int> items, std::uint64_t most_work, NestRandom& random) {
  order_by_size(scene, items);
  std::vector<int> left = lay_where_free(scene, items, random);
  // An item that failed is tried again only after all others.
  for (bool gained = true; gained && scene.work() < most_work;) {
    gained = false;
    int failed = -1;
    for (std::size_t i = 0; i < left.size() && scene.work() < most_work;) {
      const int item = left[i];
      if (item != failed && scene.shape(item, 0).area <= area_left(scene) &&
          squeeze_in(scene, item, most_work, random)) {
        left.erase(left.begin() + std::ptrdiff_t(i));
        gained = true;
      } else {
        failed = item;
        ++i;
      }
    }
  }
  return left;
}

}  // namespace tessera
