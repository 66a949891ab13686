#include "products/elements/segmentation/connected_labels.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tessera {
namespace {

constexpr int kGap = std::numeric_limits<int>::min();

/// Regions as sets of pixels, counted row by row in the map itself. The first pixel of a region holds minus its area, every
/// other one the number of an earlier pixel of the region.
class RegionSets {
 public:
  explicit RegionSets(int* pixels) : pixels_(pixels) {}

  void add(int pixel) { pixels_[pixel] = -1; }

  void join(int pixel, int other) {
    auto [first, second] = std::minmax({first_of(pixel), first_of(other)});
    if (first == second) return;
    pixels_[first] += pixels_[second];
    pixels_[second] = first;
  }

 private:
  int first_of(int pixel) {
    while (pixels_[pixel] >= 0) {
      const int next = pixels_[pixel];
      if (pixels_[next] >= 0) pixels_[pixel] = pixels_[next];
      pixel = next;
    }
    return pixel;
  }

  int* pixels_;
};

}  // namespace

cv::Mat connected_labels(const cv::Mat& labels) {
  if (labels.empty()) return {};
  cv::Mat result(labels.size(), CV_32S, cv::Scalar(kGap));
  int* pixels = result.ptr<int>();
  RegionSets sets(pixels);
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int>(y);
    const int* above = y > 0 ? labels.ptr<int>(y - 1) : nullptr;
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] <= 0) continue;
      const int pixel = y * labels.cols + x;
      sets.add(pixel);
      if (x > 0 && row[x - 1] == row[x]) sets.join(pixel, pixel - 1);
      if (above && above[x] == row[x]) sets.join(pixel, pixel - labels.cols);
    }
  }
  int count = 0;
  for (int pixel = 0; pixel < int(result.total());
       ++pixel) {  // a pixel points at an earlier one, which has its label already
    int& value = pixels[pixel];
    if (value == kGap) {
      value = 0;
    } else if (value >= 0) {
      value = pixels[value];
    } else {
      value = -value >= kLeastRegion_px2 ? ++count : 0;
    }
  }
  return result;
}

}  // namespace tessera
