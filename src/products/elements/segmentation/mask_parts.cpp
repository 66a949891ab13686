#include "products/elements/segmentation/mask_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "products/elements/segmentation/disjoint_sets.h"
#include "products/elements/segmentation/label_runs.h"

namespace tessera {
namespace {

std::vector<LabelRun> runs_of(const cv::Mat& mask) {
  std::vector<LabelRun> runs;
  append_runs(mask, {0, 0}, runs);
  return runs;
}

/// Joins the sets of runs that touch: each run with those of the row above, in one walk along both rows.
DisjointSets joined(const std::vector<LabelRun>& runs) {
  DisjointSets sets(int(runs.size()));
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const LabelRun& run = runs[i];
    const auto ends_before = [&](const LabelRun& other) {
      return other.y < run.y - 1 || (other.y == run.y - 1 && other.x + other.length <= run.x);
    };
    while (above < i && ends_before(runs[above])) ++above;
    for (std::size_t k = above; k < i && runs[k].y == run.y - 1 && runs[k].x < run.x + run.length; ++k) {
      const int a = sets.root(int(k)), b = sets.root(int(i));
      if (a != b) sets.join(std::min(a, b), std::max(a, b));
    }
  }
  return sets;
}

}  // namespace

std::vector<RegionBox> mask_parts(const cv::Mat& mask) {
  const std::vector<LabelRun> runs = runs_of(mask);
  DisjointSets sets = joined(runs);
  std::vector<RegionBox> parts;
  std::vector<std::size_t> part_of(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {  // the root is the earliest run of its part
    const cv::Rect pixels(runs[i].x, runs[i].y, runs[i].length, 1);
    const auto root = std::size_t(sets.root(int(i)));
    if (root == i) {
      part_of[i] = parts.size();
      parts.push_back({pixels, 0});
    }
    RegionBox& part = parts[part_of[root]];
    part.box |= pixels;
    part.area_px2 += pixels.width;
  }
  return parts;
}

}  // namespace tessera
