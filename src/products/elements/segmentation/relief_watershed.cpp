#include "products/elements/segmentation/relief_watershed.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "products/elements/segmentation/disjoint_sets.h"

namespace tessera {
namespace {

const std::array<cv::Point, 4> kSides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr int kOutside = 0;
constexpr int kDry = -1;

/// Labels to begin with: kDry inside the mask, kOutside elsewhere.
cv::Mat dry_ground(cv::Size size, const cv::Mat& mask) {
  cv::Mat labels(size, CV_32S, cv::Scalar(kDry));
  if (!mask.empty()) labels.setTo(kOutside, mask == 0);
  return labels;
}

/// Labels the level plain around `start` if no neighbour is lower.
class Minima {
 public:
  Minima(const cv::Mat& relief, cv::Mat& labels)
      : relief_(relief),
        labels_(labels),
        seen_(cv::Mat::zeros(relief.size(), CV_8U)),
        ground_({0, 0}, relief.size()) {}

  void label_from(cv::Point start) {
    if (labels_.at<int>(start) != kDry || seen_.at<std::uint8_t>(start) || has_lower_neighbour(start)) return;
    plain_.assign(1, start);
    seen_.at<std::uint8_t>(start) = 1;
    const float level = relief_.at<float>(start);
    bool is_minimum = true;
    for (std::size_t i = 0; i < plain_.size(); ++i) {
      const cv::Point p = plain_[i];
      for (const cv::Point side : kSides) {
        const cv::Point q = p + side;
        if (!ground_.contains(q) || labels_.at<int>(q) == kOutside) continue;
        const float beside = relief_.at<float>(q);
        if (beside < level) is_minimum = false;
        if (beside != level || seen_.at<std::uint8_t>(q)) continue;
        seen_.at<std::uint8_t>(q) = 1;
        plain_.push_back(q);
      }
    }
    if (!is_minimum) return;
    ++count_;
    for (const cv::Point p : plain_) labels_.at<int>(p) = count_;
  }

 private:
  /// Most pixels have one, and need no look at their plain.
  bool has_lower_neighbour(cv::Point p) const {
    const float level = relief_.at<float>(p);
    return std::any_of(kSides.begin(), kSides.end(), [&](cv::Point side) {
      const cv::Point q = p + side;
      return ground_.contains(q) && labels_.at<int>(q) != kOutside && relief_.at<float>(q) < level;
    });
  }

  const cv::Mat& relief_;
  cv::Mat& labels_;
  cv::Mat seen_;
  cv::Rect ground_;
  std::vector<cv::Point> plain_;
  int count_ = 0;
};

/// Pixels in the order of their levels; those of one level in the order in which they came. Each pixel enters once.
class Shore {
 public:
  /// Levels of the relief, which are told apart in steps of 1/65536 of its range.
  explicit Shore(const cv::Mat& relief) : next_(relief.total(), kNone), first_(kLevels, kNone), last_(kLevels, kNone) {
    double least = 0, greatest = 0;
    cv::minMaxLoc(relief, &least, &greatest);
    least_ = float(least);
    step_ = greatest > least ? float((kLevels - 1) / (greatest - least)) : 0;
  }

  void push(int pixel, float height) {
    const std::size_t level = std::max(level_, std::size_t((height - least_) * step_));
    (first_[level] == kNone ? first_[level] : next_[std::size_t(last_[level])]) = pixel;
    last_[level] = pixel;
  }

  /// The next pixel; -1: none is left.
  int pop() {
    while (first_[level_] == kNone) {
      if (++level_ == kLevels) return kNone;
    }
    const int pixel = first_[level_];
    first_[level_] = next_[std::size_t(pixel)];
    return pixel;
  }

 private:
  static constexpr std::size_t kLevels = 65536;
  static constexpr int kNone = -1;

  std::vector<int> next_, first_, last_;
  std::size_t level_ = 0;  // of the water
  float least_ = 0, step_ = 0;
};

/// Lets water rise from labelled pixels; on level ground it spreads evenly (first come, first served).
void flood(const cv::Mat& relief, cv::Mat& labels) {
  CV_Assert(relief.isContinuous() && labels.isContinuous());
  const float* heights = relief.ptr<float>();
  int* label = labels.ptr<int>();
  const int columns = relief.cols, end = int(relief.total());
  Shore shore(relief);
  const auto for_each_dry = [&](int pixel, auto&& visit) {
    const int x = pixel % columns;
    if (x + 1 < columns && label[pixel + 1] == kDry) visit(pixel + 1);
    if (x > 0 && label[pixel - 1] == kDry) visit(pixel - 1);
    if (pixel + columns < end && label[pixel + columns] == kDry) visit(pixel + columns);
    if (pixel >= columns && label[pixel - columns] == kDry) visit(pixel - columns);
  };
  // begins at the rims of the minima, because wide plains would fill the queue
  for (int pixel = 0; pixel < end; ++pixel) {
    bool is_rim = false;
    if (label[pixel] > 0) for_each_dry(pixel, [&](int) { is_rim = true; });
    if (is_rim) shore.push(pixel, heights[pixel]);
  }
  for (int pixel = shore.pop(); pixel >= 0; pixel = shore.pop()) {
    for_each_dry(pixel, [&](int beside) {
      label[beside] = label[pixel];
      shore.push(beside, heights[beside]);
    });
  }
}

struct Saddle {
  float level;
  int a, b;  // a < b
  bool operator<(const Saddle& o) const { return std::tie(level, a, b) < std::tie(o.level, o.a, o.b); }
};

std::vector<Saddle> saddles_between(const cv::Mat& relief, const cv::Mat& basins) {
  std::unordered_map<std::uint64_t, float> lowest;
  const auto meet = [&](cv::Point p, cv::Point q) {
    const auto [a, b] = std::minmax({basins.at<int>(p), basins.at<int>(q)});
    if (a == b || a == kOutside) return;
    const float pass = std::max(relief.at<float>(p), relief.at<float>(q));
    const auto [place, is_new] = lowest.try_emplace(std::uint64_t(a) << 32 | std::uint64_t(b), pass);
    if (!is_new) place->second = std::min(place->second, pass);
  };
  for (int y = 0; y < basins.rows; ++y) {
    for (int x = 0; x < basins.cols; ++x) {
      if (x + 1 < basins.cols) meet({x, y}, {x + 1, y});
      if (y + 1 < basins.rows) meet({x, y}, {x, y + 1});
    }
  }
  std::vector<Saddle> saddles;
  for (const auto& [pair, level] : lowest) saddles.push_back({level, int(pair >> 32), int(pair & 0xffffffff)});
  std::sort(saddles.begin(), saddles.end());
  return saddles;
}

std::vector<float> floors_of(const cv::Mat& relief, const cv::Mat& basins, int count) {
  std::vector<float> floors(std::size_t(count) + 1, std::numeric_limits<float>::infinity());
  for (int y = 0; y < basins.rows; ++y) {
    for (int x = 0; x < basins.cols; ++x) {
      float& floor = floors[std::size_t(basins.at<int>(y, x))];
      floor = std::min(floor, relief.at<float>(y, x));
    }
  }
  return floors;
}

}  // namespace

cv::Mat basins_of(const cv::Mat& relief, const cv::Mat& mask) {
  cv::Mat labels = dry_ground(relief.size(), mask);
  Minima minima(relief, labels);
  for (int y = 0; y < relief.rows; ++y) {
    for (int x = 0; x < relief.cols; ++x) minima.label_from({x, y});
  }
  flood(relief, labels);
  return labels;
}

cv::Mat merged_basins(const cv::Mat& relief, const cv::Mat& basins, const OneBasin& one_basin) {
  double greatest = 0;
  cv::minMaxLoc(basins, nullptr, &greatest);
  const int count = int(greatest);
  std::vector<float> floors = floors_of(relief, basins, count);
  DisjointSets sets(count + 1);
  for (const Saddle& saddle : saddles_between(relief, basins)) {
    const int a = sets.root(saddle.a);
    const int b = sets.root(saddle.b);
    if (a == b) continue;
    float& floor_a = floors[std::size_t(a)];
    const float floor_b = floors[std::size_t(b)];
    if (!one_basin(saddle.level, std::max(floor_a, floor_b))) continue;
    floor_a = std::min(floor_a, floor_b);
    sets.join(a, b);
  }
  std::vector<int> number(std::size_t(count) + 1, 0);
  int next = 0;
  for (int i = 1; i <= count; ++i) {
    if (sets.root(i) == i) number[std::size_t(i)] = ++next;
  }
  cv::Mat merged(basins.size(), CV_32S);
  for (int y = 0; y < basins.rows; ++y) {
    for (int x = 0; x < basins.cols; ++x) merged.at<int>(y, x) = number[std::size_t(sets.root(basins.at<int>(y, x)))];
  }
  return merged;
}

}  // namespace tessera
