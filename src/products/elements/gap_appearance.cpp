#include "products/elements/gap_appearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

constexpr int kFeatures = 5;
using Feature = cv::Vec<float, kFeatures>;
using Vector = cv::Vec<double, kFeatures>;
using Matrix = cv::Matx<double, kFeatures, kFeatures>;

constexpr std::size_t kGapSample = 20000;
/// Twice the log-likelihood ratio of element against gap, and a squared distance from the gap's look. A region below the
/// first limit and within the second looks like gap.
constexpr double kLikeGap = -1;
constexpr double kWithinGap = 12;

cv::Mat blurred(const cv::Mat& map, double sigma_px) {
  cv::Mat result;
  cv::GaussianBlur(map, result, {}, sigma_px);
  return result;
}

/// A Gaussian distribution of features around their median.
class Appearance {
 public:
  Appearance(const cv::Mat& features, const cv::Mat& mask) {
    std::vector<Feature> sample = sample_of(features, mask);
    Vector mean = Vector::all(0);
    for (const Feature& f : sample) mean += Vector(f);
    mean /= double(sample.size());
    Matrix covariance = Matrix::eye() * 1e-2;
    for (const Feature& f : sample) {
      const Vector d = Vector(f) - mean;
      covariance += d * d.t() * (1. / double(sample.size()));
    }
    inverse_ = covariance.inv(cv::DECOMP_CHOLESKY);
    log_determinant_ = std::log(cv::determinant(covariance));
    const auto middle = sample.begin() + std::ptrdiff_t(sample.size() / 2);
    for (int i = 0; i < kFeatures; ++i) {
      std::nth_element(sample.begin(), middle, sample.end(), [i](auto& a, auto& b) { return a[i] < b[i]; });
      median_[i] = (*middle)[i];
    }
  }

  /// The squared distance in standard deviations.
  double distance2(const Feature& feature) const {
    const Vector d = Vector(feature) - median_;
    return d.dot(Vector((inverse_ * d).val));
  }
  double log_determinant() const { return log_determinant_; }

 private:
  static std::vector<Feature> sample_of(const cv::Mat& features, const cv::Mat& mask) {
    const std::size_t step = std::max<std::size_t>(1, std::size_t(cv::countNonZero(mask)) / kGapSample);
    std::vector<Feature> sample;
    std::size_t i = 0;
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (mask.at<std::uint8_t>(y, x) && i++ % step == 0) sample.push_back(features.at<Feature>(y, x));
      }
    }
    return sample;
  }

  Vector median_;
  Matrix inverse_;
  double log_determinant_ = 0;
};

struct Likeness {
  double element_over_gap = 0;
  double from_gap = 0;
};

/// The means over each label's pixels.
std::vector<Likeness> likeness_of(const cv::Mat& labels, const cv::Mat& features, const Appearance& element,
                                  const Appearance& gap) {
  const std::vector<RegionBox> regions = region_boxes(labels);
  std::vector<Likeness> likeness(regions.size());
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const std::size_t label = std::size_t(labels.at<int>(y, x));
      if (label == 0) continue;
      const Feature& feature = features.at<Feature>(y, x);
      const double from_gap = gap.distance2(feature);
      const double ratio = from_gap + gap.log_determinant() - element.distance2(feature) - element.log_determinant();
      likeness[label].element_over_gap += std::clamp(ratio, -12., 12.) / regions[label].area_px2;
      likeness[label].from_gap += std::min(60., from_gap) / regions[label].area_px2;
    }
  }
  return likeness;
}

}  // namespace

cv::Mat appearance_features(const cv::Mat& bgr) {
  constexpr double kSurroundings_px = kElement_px * 0.625;
  cv::Mat features(bgr.size(), CV_32FC(kFeatures)), lightness;
  {
    cv::Mat lab;
    blurred(bgr, 1).convertTo(lab, CV_32F, 1 / 255.);
    cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
    cv::mixChannels({lab}, {features}, {0, 1, 1, 2, 2, 3});
    cv::extractChannel(lab, lightness, 0);
  }
  {
    cv::Mat relative = lightness - blurred(lightness, kSurroundings_px), deviation;
    cv::sqrt(blurred(relative.mul(relative), kSurroundings_px), deviation);
    relative /= deviation + 1;
    cv::insertChannel(relative, features, 0);
  }
  const cv::Mat mean = blurred(lightness, 3);
  cv::Mat texture;
  cv::sqrt(cv::max(blurred(lightness.mul(lightness), 3) - mean.mul(mean), 0), texture);
  cv::insertChannel(texture, features, 4);
  return features;
}

std::vector<char> are_like_gap(const cv::Mat& labels, const cv::Mat& features, const cv::Mat& gap,
                               const cv::Mat& element) {
  const std::vector<Likeness> likeness =
      likeness_of(labels, features, Appearance(features, element), Appearance(features, gap));
  std::vector<char> is_like_gap(likeness.size(), 0);
  for (std::size_t i = 1; i < likeness.size(); ++i) {
    is_like_gap[i] = likeness[i].element_over_gap < kLikeGap && likeness[i].from_gap < kWithinGap;
  }
  return is_like_gap;
}

}  // namespace tessera
