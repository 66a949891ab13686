#include "io/elements/candidate_maps.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "io/elements/boundary_map.h"
#include "io/elements/distance_split.h"
#include "io/elements/element_masks.h"
#include "io/elements/merge_tree.h"
#include "io/elements/region_labels.h"
#include "io/elements/relief_watershed.h"
#include "io/elements/trim.h"

namespace tessera::io {
namespace {

constexpr double kLeast_px2 = 0.06 * kElement_px2;
constexpr double kLeastSolidity = 0.7;

cv::Mat elements_of(const cv::Mat& mask) { return solid_regions(split_by_distance(mask), kLeast_px2, kLeastSolidity); }

double usual_area_px2(const cv::Mat& labels) {
  double sum = 0;
  const std::vector<RegionBox> regions = region_boxes(labels);
  for (std::size_t i = 1; i < regions.size(); ++i) {
    const double area_px2 = regions[i].area_px2;
    if (area_px2 > 0.25 * kElement_px2 && area_px2 < 5 * kElement_px2) sum += area_px2;
  }
  return sum;
}

/// Bright or dark elements, whichever make more solid regions of a usual size: in the best two of the levels.
std::vector<cv::Mat> by_levels(const cv::Mat& bgr) {
  const LevelMasks masks = level_masks(bgr);
  std::vector<cv::Mat> better;
  double most_px2 = -1;
  for (const std::vector<cv::Mat>& polarity : {masks.bright, masks.dark}) {
    std::vector<cv::Mat> elements;
    std::vector<double> area_px2;
    for (const cv::Mat& mask : polarity) {
      elements.push_back(elements_of(mask));
      area_px2.push_back(usual_area_px2(elements.back()));
    }
    std::sort(area_px2.rbegin(), area_px2.rend());
    if (area_px2[0] + area_px2[1] <= most_px2) continue;
    most_px2 = area_px2[0] + area_px2[1];
    better = elements;
  }
  return better;
}

std::vector<cv::Mat> by_colours(const cv::Mat& lab) {
  std::vector<cv::Mat> maps;
  for (const int colour_count : {3, 4, 5}) maps.push_back(elements_of(colour_mask(lab, colour_count)));
  return maps;
}

/// Basins shallower than `depth` are one with their neighbours.
cv::Mat deep_basins(const cv::Mat& relief, const cv::Mat& basins, double depth) {
  return merged_basins(relief, basins, [depth](float saddle, float floor) { return saddle - floor < depth; });
}

std::vector<cv::Mat> by_gradient(const cv::Mat& lab) {
  std::vector<cv::Mat> maps;
  const cv::Mat gradient = colour_gradient(lab, 2, 1.5);
  const cv::Mat basins = basins_of(gradient);
  const double steep = quantile_of(gradient, 0.9);
  for (const double depth : {0.2, 0.35, 0.55}) {
    maps.push_back(solid_regions(deep_basins(gradient, basins, depth * steep), kLeast_px2, kLeastSolidity));
  }
  return maps;
}

struct Leaves {
  double depth;  // of the basins that the tree starts from
  double solidity_power;
};

std::vector<cv::Mat> by_merges(const cv::Mat& lab, const BoundaryKind& kind, const std::vector<Leaves>& trees) {
  cv::Mat boundary;
  cv::GaussianBlur(boundary_map(lab, kind), boundary, {}, 1);
  const cv::Mat basins = basins_of(boundary);
  std::vector<cv::Mat> maps;
  for (const Leaves& leaves : trees) {
    const cv::Mat found =
        best_of_merge_tree(boundary, deep_basins(boundary, basins, leaves.depth), leaves.solidity_power);
    maps.push_back(solid_regions(trimmed_regions(found, lab), kLeast_px2, kLeastSolidity));
  }
  return maps;
}

}  // namespace

std::vector<cv::Mat> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab) {
  const std::vector<std::function<std::vector<cv::Mat>()>> ways = {
      [&] {
        return by_merges(lab, {0.5, 1.2, 9}, {{0.03, 4}, {0.08, 4}, {0.15, 4}});
      },
      [&] { return by_levels(bgr); },
      [&] { return by_colours(lab); },
      [&] { return by_gradient(lab); },
      [&] {
        return by_merges(lab, {2, 1.2, 13}, {{0.06, 4}});
      },
      [&] {
        return by_merges(lab, {1, 1.8, 9}, {{0.1, 6}});
      },
  };
  std::vector<std::vector<cv::Mat>> found(ways.size());
  std::vector<std::exception_ptr> thrown(ways.size());  // not every backend of parallel_for_ carries them over
  const auto go = [&](std::size_t way) {
    try {
      found[way] = ways[way]();
    } catch (...) {
      thrown[way] = std::current_exception();
    }
  };
  cv::parallel_for_({0, int(ways.size())}, [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) go(std::size_t(i));
  });
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
  std::vector<cv::Mat> maps;
  for (const std::vector<cv::Mat>& some : found) maps.insert(maps.end(), some.begin(), some.end());
  return maps;
}

}  // namespace tessera::io
