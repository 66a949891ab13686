#include "products/elements/segmentation/region_vote.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <span>

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

/// The runs of a map row by row, so that two maps can be compared in one walk along both.
class RowRuns {
 public:
  struct Run {
    int x, end;  // px; `end` is behind the last one
    int label;
  };

  explicit RowRuns(const LabelRuns& labels) : first_(std::size_t(labels.size().height) + 1, 0) {
    const std::size_t count = labels.regions().size();
    for (std::size_t label = 1; label < count; ++label) {
      for (const LabelRun& run : labels.runs_of(label)) ++first_[std::size_t(run.y) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    runs_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t label = 1; label < count; ++label) {
      for (const LabelRun& run : labels.runs_of(label))
        runs_[next[std::size_t(run.y)]++] = {run.x, run.x + run.length, int(label)};
    }
    for (std::size_t y = 0; y + 1 < first_.size(); ++y) {
      std::sort(runs_.begin() + std::ptrdiff_t(first_[y]), runs_.begin() + std::ptrdiff_t(first_[y + 1]),
                [](const Run& a, const Run& b) { return a.x < b.x; });
    }
  }

  std::size_t rows() const { return first_.size() - 1; }
  std::span<const Run> row(std::size_t y) const {
    return std::span(runs_).subspan(first_[y], first_[y + 1] - first_[y]);
  }

 private:
  std::vector<std::size_t> first_;  // of each row: its first run in runs_; at the end, the number of runs
  std::vector<Run> runs_;
};

/// Calls f(a, b, px) where regions a and b of two maps share so many pixels of a row.
template <class F>
void each_shared(const RowRuns& first, const RowRuns& second, F f) {
  for (std::size_t y = 0; y < first.rows(); ++y) {
    const std::span<const RowRuns::Run> a = first.row(y), b = second.row(y);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const int shared = std::min(a[i].end, b[j].end) - std::max(a[i].x, b[j].x);
      if (shared > 0) f(a[i].label, b[j].label, shared);
      a[i].end < b[j].end ? ++i : ++j;
    }
  }
}

/// The common pixels of the regions of two maps.
class CommonPixels {
 public:
  struct Common {
    int first, second;  // regions
    int px2;
    int next;  // the next one of the same first region
  };

  explicit CommonPixels(std::size_t first_count) : newest_(first_count, kNone) {}

  void add(int first, int second, int px2) {
    for (int i = newest_[std::size_t(first)]; i != kNone; i = all_[std::size_t(i)].next) {
      if (all_[std::size_t(i)].second == second) {
        all_[std::size_t(i)].px2 += px2;
        return;
      }
    }
    all_.push_back({first, second, px2, newest_[std::size_t(first)]});
    newest_[std::size_t(first)] = int(all_.size()) - 1;
  }

  const std::vector<Common>& all() const { return all_; }

 private:
  static constexpr int kNone = -1;

  std::vector<int> newest_;  // of each first region: its newest place in all_
  std::vector<Common> all_;
};

/// For each region of two maps the greatest intersection over union with a region of the other map; 0 where it is less
/// than kAgreeFrom.
struct Agreement {
  std::vector<double> of_first, of_second;
};

Agreement agreement_of(const Map& first, const RowRuns& first_rows, const Map& second, const RowRuns& second_rows) {
  const auto area = [](const Map& map, int label) { return map.regions()[std::size_t(label)].area_px2; };
  CommonPixels common(first.regions().size());
  each_shared(first_rows, second_rows, [&](int a, int b, int px2) {
    // Most regions that overlap differ so much in size that they cannot agree.
    const double one_px2 = area(first, a), other_px2 = area(second, b);
    if (std::min(one_px2, other_px2) >= kAgreeFrom * std::max(one_px2, other_px2)) common.add(a, b, px2);
  });
  Agreement best{std::vector<double>(first.regions().size(), 0), std::vector<double>(second.regions().size(), 0)};
  for (const CommonPixels::Common& c : common.all()) {
    const double agreement = c.px2 / (area(first, c.first) + area(second, c.second) - c.px2);
    double &of_first = best.of_first[std::size_t(c.first)], &of_second = best.of_second[std::size_t(c.second)];
    of_first = std::max(of_first, agreement);
    of_second = std::max(of_second, agreement);
  }
  return best;
}

void add_votes(Map& map, double weight, const std::vector<double>& agreement) {
  for (std::size_t i = 1; i < agreement.size(); ++i)
    map.votes[i] += weight * std::clamp((agreement[i] - kAgreeFrom) / (kAgreeFully - kAgreeFrom), 0., 1.);
}

/// Each region gets a vote of each other map, from the region there that agrees with it best. A map gets its votes in the
/// order of the other maps, so that the sums are the same on any number of threads.
void vote(std::vector<Map>& maps) {
  std::vector<RowRuns> rows;
  for (const Map& map : maps) rows.emplace_back(*map.labels);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    std::vector<Agreement> with_later(maps.size());
    cv::parallel_for_({int(i) + 1, int(maps.size())}, [&](const cv::Range& range) {
      for (auto j = std::size_t(range.start); j < std::size_t(range.end); ++j) {
        with_later[j] = agreement_of(maps[i], rows[i], maps[j], rows[j]);
        add_votes(maps[j], maps[i].weight, with_later[j].of_second);
      }
    });
    for (std::size_t j = i + 1; j < maps.size(); ++j) add_votes(maps[i], maps[j].weight, with_later[j].of_first);
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
  vote(maps);
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
