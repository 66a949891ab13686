#include "products/elements/segmentation/region_vote.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

constexpr double kSolidRegion = 0.75;
/// Solidity of a finished region, which may have lost a part to others.
constexpr double kLeastSolidityLeft = 0.67;
/// Part of the possible votes.
constexpr double kLeastVotes = 0.125;
/// Intersection over union at which two regions begin to agree, and at which they fully do.
constexpr double kAgreeFrom = 0.6;
constexpr double kAgreeFully = 0.9;
/// Values of the boundary map. If a quarter of a region's border is weaker, the region is ground cut from ground. A region
/// with few votes needs the first one. Each part of all votes beyond that makes up for as much of the border, down to the
/// second one: what is cut from ground at random is not cut in the same way twice.
constexpr double kLeastBorder = 0.4;
constexpr double kLeastBorderOfAgreed = 0.35;
/// Least part of a region that better regions must leave.
constexpr double kLeastFree = 0.85;

struct Map {
  const LabelRuns* labels;
  std::vector<double> solidity;
  std::vector<double> votes;
  double weight = 1;

  const std::vector<RegionBox>& regions() const { return labels->regions(); }
};

Map map_of(const LabelRuns& labels, double element_px2) {
  Map map{&labels, {}, {}, 1};
  map.solidity.resize(map.regions().size());
  map.votes.resize(map.regions().size());
  double good_px2 = 0;
  for (std::size_t i = 1; i < map.regions().size(); ++i) {
    const RegionBox& region = map.regions()[i];
    if (region.area_px2 == 0) continue;
    map.solidity[i] = solidity_of(labels.mask_of(i));
    const bool is_usual = region.area_px2 > 0.1 * element_px2 && region.area_px2 < 10 * element_px2;
    if (is_usual && map.solidity[i] > 0.87) good_px2 += region.area_px2;
  }
  map.weight = good_px2 / double(labels.size().area());
  return map;
}

/// Gives maps with more good regions more weight (by the square root); the sum of weights is their number.
void balance_weights(std::vector<Map>& maps) {
  double most = 0, sum = 0;
  for (const Map& map : maps) most = std::max(most, map.weight);
  if (most == 0) return;
  for (Map& map : maps) sum += map.weight = std::sqrt(map.weight / most);
  for (Map& map : maps) map.weight *= double(maps.size()) / sum;
}

/// For each pixel how many pixels from it to the right have its label, up to 65535: CV_16U.
cv::Mat lengths_to_the_right(const cv::Mat& labels) {
  cv::Mat lengths(labels.size(), CV_16U, cv::Scalar(1));
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int>(y);
    std::uint16_t* length = lengths.ptr<std::uint16_t>(y);
    for (int x = labels.cols - 2; x >= 0; --x) {
      if (row[x] == row[x + 1] && length[x + 1] < UINT16_MAX) length[x] = std::uint16_t(length[x + 1] + 1);
    }
  }
  return lengths;
}

/// Gives each region of `map` a vote of `other` (labels `others`, and their lengths to the right), from the region there
/// that agrees with it best.
void add_votes(Map& map, const Map& other, const cv::Mat& others, const cv::Mat& lengths) {
  std::vector<int> common_px2(other.regions().size(), 0);
  std::vector<int> met;
  for (std::size_t i = 1; i < map.regions().size(); ++i) {
    const RegionBox& region = map.regions()[i];
    met.clear();
    for (const LabelRun& run : map.labels->runs_of(i)) {
      const int* row = others.ptr<int>(run.y) + run.x;
      const std::uint16_t* length = lengths.ptr<std::uint16_t>(run.y) + run.x;
      for (int x = 0, step = 0; x < run.length; x += step) {
        step = std::min(int(length[x]), run.length - x);
        if (row[x] == 0) continue;
        int& common = common_px2[std::size_t(row[x])];
        if (common == 0) met.push_back(row[x]);
        common += step;
      }
    }
    double best = 0;
    for (const int there : met) {
      const double common = common_px2[std::size_t(there)];
      best = std::max(best, common / (region.area_px2 + other.regions()[std::size_t(there)].area_px2 - common));
      common_px2[std::size_t(there)] = 0;
    }
    map.votes[i] += other.weight * std::clamp((best - kAgreeFrom) / (kAgreeFully - kAgreeFrom), 0., 1.);
  }
}

/// The strength of the weaker part (first quarter) of the boundary map along the region's outline.
double border_strength(const cv::Mat& mask, const cv::Mat& boundary) {
  cv::Mat inner;
  cv::erode(mask, inner, cv::Mat::ones(3, 3, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
  std::vector<float> along;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) && !inner.at<std::uint8_t>(y, x)) along.push_back(boundary.at<float>(y, x));
    }
  }
  const auto quarter = along.begin() + std::ptrdiff_t(along.size() / 4);
  std::nth_element(along.begin(), quarter, along.end());
  return *quarter;
}

struct Candidate {
  double score;
  const Map* map;
  int label;
};

/// `votes`: part of the possible votes.
double least_border(double votes) {
  return std::max(kLeastBorderOfAgreed, kLeastBorder - std::max(0., votes - kLeastVotes));
}

/// The score of a region; 0 where it cannot be an element. `votes`: part of the possible votes.
double score_of(const Map& map, std::size_t i, double votes, const cv::Mat& boundary, double element_px2) {
  const RegionBox& region = map.regions()[i];
  const double border = border_strength(map.labels->mask_of(i), boundary(region.box));
  if (border < least_border(votes)) return 0;
  const double size = region.area_px2 / element_px2;
  return std::pow(map.solidity[i], 3) * std::pow(map.votes[i], 0.6) * size_preference(size, 1.6, 0.6) *
         std::sqrt(map.weight) * std::sqrt(std::min(1., border + 0.1)) * std::pow(std::min(4., size), 0.3);
}

}  // namespace

VotedRegions voted_regions(const std::vector<LabelRuns>& label_maps, const cv::Mat& boundary, double element_px) {
  const double element_px2 = element_px * element_px;
  std::vector<Map> maps;
  for (const LabelRuns& labels : label_maps) maps.push_back(map_of(labels, element_px2));
  balance_weights(maps);
  for (const Map& other : maps) {  // one after the other, because its labels take memory
    const cv::Mat others = other.labels->labels();
    const cv::Mat lengths = lengths_to_the_right(others);
    cv::parallel_for_({0, int(maps.size())}, [&](const cv::Range& range) {
      for (int i = range.start; i < range.end; ++i) {
        if (&maps[std::size_t(i)] != &other) add_votes(maps[std::size_t(i)], other, others, lengths);
      }
    });
  }
  cv::Mat near_boundary;
  cv::dilate(boundary, near_boundary, cv::Mat::ones(5, 5, CV_8U));
  std::vector<Candidate> candidates;
  for (const Map& map : maps) {
    for (std::size_t i = 1; i < map.regions().size(); ++i) {
      if (map.solidity[i] < kSolidRegion || map.votes[i] < kLeastVotes * double(maps.size())) continue;
      const double score = score_of(map, i, map.votes[i] / double(maps.size() - 1), near_boundary, element_px2);
      if (score > 0) candidates.push_back({score, &map, int(i)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](auto& a, auto& b) { return a.score > b.score; });

  cv::Mat chosen = cv::Mat::zeros(boundary.size(), CV_32S);
  int next = 0;
  double support_px2 = 0;
  for (const Candidate& candidate : candidates) {
    const RegionBox& region = candidate.map->regions()[std::size_t(candidate.label)];
    cv::Mat there = chosen(region.box);
    const cv::Mat free = candidate.map->labels->mask_of(std::size_t(candidate.label)) & (there == 0);
    if (cv::countNonZero(free) < kLeastFree * region.area_px2) continue;
    there.setTo(++next, free);
    const auto label = std::size_t(candidate.label);
    support_px2 +=
        region.area_px2 * candidate.map->solidity[label] * candidate.map->votes[label] / double(maps.size() - 1);
  }
  return {solid_regions(chosen, 0.05 * element_px2, kLeastSolidityLeft), support_px2};
}

}  // namespace tessera
