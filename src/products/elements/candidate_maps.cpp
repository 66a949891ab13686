#include "products/elements/candidate_maps.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "products/elements/element_masks.h"
#include "products/elements/segmentation/boundary_map.h"
#include "products/elements/segmentation/distance_split.h"
#include "products/elements/segmentation/merge_tree.h"
#include "products/elements/segmentation/region_labels.h"
#include "products/elements/segmentation/relief_watershed.h"
#include "products/elements/trim.h"

namespace tessera {
namespace {

constexpr double kLeastCandidate_px2 = 0.06 * kElement_px2;
constexpr double kSolidCandidate = 0.7;
/// Upper bound of the pixels of all ways that run at a time.
constexpr double kMostMapped_px2 = 6e6;

cv::Mat elements_of(const cv::Mat& mask) {
  return solid_regions(split_by_distance(mask), kLeastCandidate_px2, kSolidCandidate);
}

double usual_area_px2(const std::vector<RegionBox>& regions) {
  double sum = 0;
  for (std::size_t i = 1; i < regions.size(); ++i) {
    const double area_px2 = regions[i].area_px2;
    if (area_px2 > 0.25 * kElement_px2 && area_px2 < 5 * kElement_px2) sum += area_px2;
  }
  return sum;
}

/// Receives label maps in their own size.
using Take = std::function<void(const cv::Mat&)>;

/// Finds bright or dark elements, whichever give more solid regions of a usual size, in the best two levels.
void by_levels(const cv::Mat& bgr, const Take& take) {
  const LevelMasks masks = level_masks(bgr);
  std::vector<LabelRuns> better;
  double most_px2 = -1;
  for (const std::vector<cv::Mat>& polarity : {masks.bright, masks.dark}) {
    std::vector<LabelRuns> elements;
    std::vector<double> area_px2;
    for (const cv::Mat& mask : polarity) {
      elements.emplace_back(elements_of(mask));
      area_px2.push_back(usual_area_px2(elements.back().regions()));
    }
    std::sort(area_px2.rbegin(), area_px2.rend());
    if (area_px2[0] + area_px2[1] <= most_px2) continue;
    most_px2 = area_px2[0] + area_px2[1];
    better = std::move(elements);
  }
  for (const LabelRuns& map : better) take(map.labels());
}

void by_colours(const cv::Mat& lab, const Take& take) {
  const cv::Mat colours = relative_colours(lab);
  for (const int colour_count : {3, 4, 5}) take(elements_of(colour_mask(colours, colour_count)));
}

/// Merges basins shallower than `depth` with their neighbours.
cv::Mat deep_basins(const BasinMerger& basins, double depth) {
  return basins.merged([depth](float saddle, float floor) { return saddle - floor < depth; });
}

void by_gradient(const cv::Mat& lab, const Take& take) {
  const cv::Mat gradient = colour_gradient(lab, 2, 1.5);
  const BasinMerger basins(gradient, basins_of(gradient));
  const double steep = quantile_of(gradient, 0.9);
  for (const double depth : {0.2, 0.35, 0.55}) {
    take(solid_regions(deep_basins(basins, depth * steep), kLeastCandidate_px2, kSolidCandidate));
  }
}

struct Leaves {
  double depth;  // of the basins that the tree begins with
  double solidity_power;
};

void by_merges(const cv::Mat& lab, const BoundaryKind& kind, const std::vector<Leaves>& trees, const Take& take) {
  cv::Mat boundary;
  cv::GaussianBlur(boundary_map(lab, kind), boundary, {}, 1);
  const BasinMerger basins(boundary, basins_of(boundary));
  for (const Leaves& leaves : trees) {
    const cv::Mat found = best_of_merge_tree(boundary, deep_basins(basins, leaves.depth), leaves.solidity_power);
    take(solid_regions(trimmed_regions(found, lab), kLeastCandidate_px2, kSolidCandidate));
  }
}

/// A way to find elements; it gives its maps to `take`, one after the other.
using Way = std::function<void(const Take& take)>;

std::vector<Way> ways_to_find(const cv::Mat& bgr, const cv::Mat& lab) {
  return {
      [&](const Take& take) {
        by_merges(lab, {0.5, 1.2, 9}, {{0.03, 4}, {0.08, 4}, {0.15, 4}}, take);
      },
      [&](const Take& take) { by_levels(bgr, take); },
      [&](const Take& take) { by_colours(lab, take); },
      [&](const Take& take) { by_gradient(lab, take); },
      [&](const Take& take) {
        by_merges(lab, {2, 1.2, 13}, {{0.06, 4}}, take);
      },
      [&](const Take& take) {
        by_merges(lab, {1, 1.8, 9}, {{0.1, 6}}, take);
      },
  };
}

/// The maps of one way, scaled to `size`.
std::vector<LabelRuns> maps_of(const Way& way, cv::Size size) {
  std::vector<LabelRuns> maps;
  way([&](const cv::Mat& labels) {
    cv::Mat sized = labels;
    if (labels.size() != size) cv::resize(labels, sized, size, 0, 0, cv::INTER_NEAREST);
    maps.emplace_back(sized);
  });
  return maps;
}

}  // namespace

std::vector<LabelRuns> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab, cv::Size size) {
  const std::vector<Way> ways = ways_to_find(bgr, lab);
  std::vector<std::vector<LabelRuns>> found(ways.size());
  std::vector<std::exception_ptr> thrown(ways.size());  // not every backend of parallel_for_ passes them on
  const auto go = [&](std::size_t way) {
    try {
      found[way] = maps_of(ways[way], size);
    } catch (...) {
      thrown[way] = std::current_exception();
    }
  };
  const int at_a_time = std::clamp(int(kMostMapped_px2 / double(bgr.total())), 1, int(ways.size()));
  for (int first = 0; first < int(ways.size()); first += at_a_time) {
    cv::parallel_for_({first, std::min(first + at_a_time, int(ways.size()))}, [&](const cv::Range& range) {
      for (int i = range.start; i < range.end; ++i) go(std::size_t(i));
    });
  }
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
  std::vector<LabelRuns> maps;
  for (std::vector<LabelRuns>& some : found)
    maps.insert(maps.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return maps;
}

}  // namespace tessera
