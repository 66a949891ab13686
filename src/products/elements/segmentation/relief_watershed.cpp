#include "products/elements/segmentation/relief_watershed.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "products/elements/segmentation/disjoint_sets.h"

namespace tessera {
namespace {

using Saddle = BasinMerger::Saddle;

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
    const float* height = relief_.ptr<float>(p.y) + p.x;
    const int* label = labels_.ptr<int>(p.y) + p.x;
    const auto is_lower = [&](std::ptrdiff_t to) { return height[to] < *height && label[to] != kOutside; };
    const std::ptrdiff_t below = relief_.cols;  // both are continuous
    return (p.x + 1 < relief_.cols && is_lower(1)) || (p.x > 0 && is_lower(-1)) ||
           (p.y + 1 < relief_.rows && is_lower(below)) || (p.y > 0 && is_lower(-below));
  }

  const cv::Mat& relief_;
  cv::Mat& labels_;
  cv::Mat seen_;
  cv::Rect ground_;
  std::vector<cv::Point> plain_;
  int count_ = 0;
};

/// Pixels that wait in queues, one for each level of the relief. The lowest level's come first; those of one level in the
/// order in which they came.
///
/// A queue is a list of chunks. So the caller learns which pixels come next, and can load them into the cache before.
class LevelQueues {
 public:
  static constexpr int kNone = -1;
  static constexpr std::size_t kLevels = 65536;

  LevelQueues() : queues_(kLevels) {}

  /// A level below that of the last pixel counts as that level.
  void push(std::size_t level, int pixel) {
    Queue& queue = queues_[std::max(level, level_)];
    if (queue.last == kNone || queue.last_size == kChunk) add_chunk(queue);
    chunks_[std::size_t(queue.last)].pixels[std::size_t(queue.last_size++)] = pixel;
  }

  /// The next pixel; kNone: none is left. Calls soon(pixel) for each pixel that waits in a chunk when its turn comes.
  template <class Soon>
  int pop(Soon soon) {
    while (at_ == size_of_first()) {
      if (!goes_on()) return kNone;
      for (int i = 0; i < size_of_first(); ++i)
        soon(chunks_[std::size_t(queues_[level_].first)].pixels[std::size_t(i)]);
    }
    return chunks_[std::size_t(queues_[level_].first)].pixels[std::size_t(at_++)];
  }

 private:
  static constexpr int kChunk = 15;

  struct Chunk {
    std::array<int, kChunk> pixels;
    int next;  // chunk of the same queue, or free one
  };
  struct Queue {
    int first = kNone, last = kNone;  // chunks
    int last_size = 0;                // pixels in the last one; all others are full
  };

  void add_chunk(Queue& queue) {
    int chunk = free_;
    if (chunk == kNone) {
      chunk = int(chunks_.size());
      chunks_.emplace_back();
    } else {
      free_ = chunks_[std::size_t(chunk)].next;
    }
    (queue.last == kNone ? queue.first : chunks_[std::size_t(queue.last)].next) = chunk;
    queue.last = chunk;
    queue.last_size = 0;
  }

  /// The number of pixels in the level's first chunk; 0 where the level has none.
  int size_of_first() const {
    const Queue& queue = queues_[level_];
    return queue.first == queue.last ? queue.last_size : kChunk;
  }

  /// Leaves the level's first chunk, whose pixels are all taken, for the next one, or for the next level.
  bool goes_on() {
    at_ = 0;
    Queue& queue = queues_[level_];
    if (queue.first == kNone) return ++level_ < kLevels;
    const int taken = queue.first;
    if (taken == queue.last) {
      queue = {};
    } else {
      queue.first = chunks_[std::size_t(taken)].next;
    }
    chunks_[std::size_t(taken)].next = free_;
    free_ = taken;
    return true;
  }

  std::vector<Queue> queues_;
  std::vector<Chunk> chunks_;
  int free_ = kNone;       // the first chunk that no queue uses
  std::size_t level_ = 0;  // of the pixel that came last
  int at_ = 0;             // in the first chunk of that level
};

/// Lets water rise from labelled pixels; on level ground it spreads evenly (first come, first served). Each pixel waits once
/// for the water to reach its level.
///
/// The water jumps all over the picture, so that most time is spent waiting for memory. What it needs of a pixel lies
/// together and is loaded before; a rim outside the picture saves it from looking where the picture ends. This takes half
/// the time.
class Flood {
 public:
  Flood(const cv::Mat& relief, const cv::Mat& labels)
      : below_(relief.cols + 2),
        pixels_(std::size_t(below_) * std::size_t(relief.rows + 2), {kOutside, 0}) {
    double least = 0, greatest = 0;
    cv::minMaxLoc(relief, &least, &greatest);
    const float floor = float(least), step = greatest > least ? float((kLevels - 1) / (greatest - least)) : 0;
    for (int y = 0; y < relief.rows; ++y) {
      Pixel* pixel = &pixels_[std::size_t(at(0, y))];
      for (int x = 0; x < relief.cols; ++x)
        pixel[x] = {labels.at<int>(y, x), int((relief.at<float>(y, x) - floor) * step)};
    }
  }

  void rise() {
    // begins at the rims of the minima, because wide plains would fill the queue
    for (int pixel = below_; pixel < int(pixels_.size()) - below_; ++pixel) {
      bool is_rim = false;
      if (label(pixel) > 0) for_each_dry_beside(pixel, [&](int) { is_rim = true; });
      if (is_rim) wait(pixel);
    }
    const auto load = [&](int pixel) {
      for (const int there : {pixel, pixel - below_, pixel + below_}) __builtin_prefetch(&pixels_[std::size_t(there)]);
    };
    for (int pixel = queues_.pop(load); pixel != LevelQueues::kNone; pixel = queues_.pop(load)) {
      for_each_dry_beside(pixel, [&](int beside) {
        pixels_[std::size_t(beside)].label = label(pixel);
        wait(beside);
      });
    }
  }

  void write_to(cv::Mat& labels) const {
    for (int y = 0; y < labels.rows; ++y) {
      for (int x = 0; x < labels.cols; ++x) labels.at<int>(y, x) = label(at(x, y));
    }
  }

 private:
  static constexpr std::size_t kLevels = LevelQueues::kLevels;

  struct Pixel {
    int label;
    int level;  // of the relief, in steps of 1/65536 of its range
  };

  int at(int x, int y) const { return (y + 1) * below_ + x + 1; }
  int label(int pixel) const { return pixels_[std::size_t(pixel)].label; }
  void wait(int pixel) { queues_.push(std::size_t(pixels_[std::size_t(pixel)].level), pixel); }

  template <class Visit>
  void for_each_dry_beside(int pixel, Visit visit) {
    for (const int beside : {pixel + 1, pixel - 1, pixel + below_, pixel - below_}) {
      if (label(beside) == kDry) visit(beside);
    }
  }

  int below_;  // from a pixel to the one below it
  std::vector<Pixel> pixels_;
  LevelQueues queues_;
};

/// The lowest saddle between each two neighbouring basins.
class LowestSaddles {
 public:
  explicit LowestSaddles(int basin_count) : newest_(std::size_t(basin_count) + 1, kNone) {}

  /// Basins a < b meet at this level.
  void meet(int a, int b, float level) {
    for (int i = newest_[std::size_t(a)]; i != kNone; i = next_[std::size_t(i)]) {
      Saddle& saddle = saddles_[std::size_t(i)];
      if (saddle.b != b) continue;
      saddle.level = std::min(saddle.level, level);
      return;
    }
    next_.push_back(newest_[std::size_t(a)]);
    newest_[std::size_t(a)] = int(saddles_.size());
    saddles_.push_back({level, a, b});
  }

  std::vector<Saddle> sorted() && {
    const auto place = [](const Saddle& saddle) { return std::tie(saddle.level, saddle.a, saddle.b); };
    std::sort(saddles_.begin(), saddles_.end(), [&](const Saddle& a, const Saddle& b) { return place(a) < place(b); });
    return std::move(saddles_);
  }

 private:
  static constexpr int kNone = -1;

  std::vector<Saddle> saddles_;
  std::vector<int> next_;    // of each saddle: an earlier one of the same basin a
  std::vector<int> newest_;  // of each basin a
};

std::vector<Saddle> saddles_between(const cv::Mat& relief, const cv::Mat& basins, int count) {
  LowestSaddles lowest(count);
  const auto meet = [&](cv::Point p, cv::Point q) {
    const auto [a, b] = std::minmax({basins.at<int>(p), basins.at<int>(q)});
    if (a != b && a != kOutside) lowest.meet(a, b, std::max(relief.at<float>(p), relief.at<float>(q)));
  };
  for (int y = 0; y < basins.rows; ++y) {
    for (int x = 0; x < basins.cols; ++x) {
      if (x + 1 < basins.cols) meet({x, y}, {x + 1, y});
      if (y + 1 < basins.rows) meet({x, y}, {x, y + 1});
    }
  }
  return std::move(lowest).sorted();
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
  CV_Assert(relief.isContinuous());
  cv::Mat labels = dry_ground(relief.size(), mask);
  {
    Minima minima(relief, labels);
    for (int y = 0; y < relief.rows; ++y) {
      for (int x = 0; x < relief.cols; ++x) minima.label_from({x, y});
    }
  }
  Flood flood(relief, labels);
  flood.rise();
  flood.write_to(labels);
  return labels;
}

BasinMerger::BasinMerger(const cv::Mat& relief, const cv::Mat& basins) : basins_(basins) {
  double greatest = 0;
  cv::minMaxLoc(basins, nullptr, &greatest);
  floors_ = floors_of(relief, basins, int(greatest));
  saddles_ = saddles_between(relief, basins, int(greatest));
}

cv::Mat BasinMerger::merged(const OneBasin& one_basin) const {
  std::vector<float> floors = floors_;
  const int count = int(floors.size()) - 1;
  DisjointSets sets(count + 1);
  for (const Saddle& saddle : saddles_) {
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
  for (int i = 1; i <= count; ++i) number[std::size_t(i)] = number[std::size_t(sets.root(i))];
  cv::Mat merged(basins_.size(), CV_32S);
  for (int y = 0; y < basins_.rows; ++y) {
    for (int x = 0; x < basins_.cols; ++x) merged.at<int>(y, x) = number[std::size_t(basins_.at<int>(y, x))];
  }
  return merged;
}

}  // namespace tessera
