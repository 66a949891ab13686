#include "products/elements/segmentation/colour_clusters.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tessera {
namespace {

/// Centres are found with about this many pixels, evenly spread.
constexpr std::size_t kSample = 20000;
constexpr int kAttempts = 3;
constexpr int kRounds = 30;

using Colours = std::vector<cv::Vec3f>;

Colours sample_of(const cv::Mat& colours) {
  const std::size_t step = std::max<std::size_t>(1, colours.total() / kSample);
  Colours sample;
  for (std::size_t i = 0; i < colours.total(); i += step) {
    sample.push_back(colours.at<cv::Vec3f>(int(i / std::size_t(colours.cols)), int(i % std::size_t(colours.cols))));
  }
  return sample;
}

double squared_distance(const cv::Vec3f& a, const cv::Vec3f& b) {
  const cv::Vec3f d = a - b;
  return double(d.dot(d));
}

struct Nearest {
  int centre = 0;
  double squared_distance = std::numeric_limits<double>::infinity();
};

Nearest nearest_of(const Colours& centres, const cv::Vec3f& colour) {
  Nearest nearest;
  for (int i = 0; i < int(centres.size()); ++i) {
    const double d = squared_distance(centres[std::size_t(i)], colour);
    if (d < nearest.squared_distance) nearest = {i, d};
  }
  return nearest;
}

/// k-means++: draws the next centre with the squared distance to the present centres as weight.
Colours first_centres(const Colours& sample, int count, cv::RNG& random) {
  Colours centres = {sample[std::size_t(random.uniform(0, int(sample.size())))]};
  std::vector<double> weight(sample.size());
  while (int(centres.size()) < count) {
    double sum = 0;
    for (std::size_t i = 0; i < sample.size(); ++i) sum += weight[i] = nearest_of(centres, sample[i]).squared_distance;
    double left = random.uniform(0., 1.) * sum;
    std::size_t drawn = 0;
    while (drawn + 1 < sample.size() && (left -= weight[drawn]) > 0) ++drawn;
    centres.push_back(sample[drawn]);
  }
  return centres;
}

/// Makes one round of Lloyd's algorithm and returns the sum of squared distances before it. A centre without pixels stays.
double improve(Colours& centres, const Colours& sample) {
  std::vector<cv::Vec3d> sum(centres.size(), {0, 0, 0});
  std::vector<int> members(centres.size(), 0);
  double spread = 0;
  for (const cv::Vec3f& colour : sample) {
    const Nearest nearest = nearest_of(centres, colour);
    spread += nearest.squared_distance;
    sum[std::size_t(nearest.centre)] += cv::Vec3d(colour);
    ++members[std::size_t(nearest.centre)];
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (members[i] > 0) centres[i] = sum[i] / members[i];
  }
  return spread;
}

}  // namespace

cv::Mat colour_clusters(const cv::Mat& colours, int count) {
  const Colours sample = sample_of(colours);
  cv::RNG random(1);
  Colours best;
  double least_spread = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Colours centres = first_centres(sample, count, random);
    double spread = 0;
    for (int round = 0; round < kRounds; ++round) {
      const Colours before = centres;
      spread = improve(centres, sample);
      if (centres == before) break;  // later rounds would find the same
    }
    if (spread >= least_spread) continue;
    least_spread = spread;
    best = centres;
  }
  cv::Mat clusters(colours.size(), CV_8U);
  for (int y = 0; y < colours.rows; ++y) {
    for (int x = 0; x < colours.cols; ++x) {
      clusters.at<std::uint8_t>(y, x) = std::uint8_t(nearest_of(best, colours.at<cv::Vec3f>(y, x)).centre);
    }
  }
  return clusters;
}

}  // namespace tessera
