#include "io/artwork/solid_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "io/artwork/alpha_regions.h"

namespace tessera::io {
namespace {

// Of 255.
constexpr int kHalf = 128;
constexpr int kBarelyHalf = 153;  // an outline at one half lies inside of the edge
constexpr int kLeastLevel = 51;   // of a part that counts
/// Of a region; where thin lines cross each other, alpha is smooth, too.
constexpr int kLeastPixels = 256;
constexpr double kFlatPart = 0.7;
/// Of the ways in which a region ends, one prevails that is so many times as long as the other.
constexpr int kMostly = 2;

/// A region in which coverage is not alpha.
enum class Kind : std::uint8_t { as_opaque, solid, shadow };

bool is_large(const AlphaRegion& region, int unit_px) { return region.core_pixels >= kLeastPixels * unit_px * unit_px; }

/// What is far less opaque than the part it belongs to is its end.
int least_counted(const AlphaRegion& region) { return int(region.level / 2); }

bool is_solid(const AlphaRegion& region) {
  return region.level >= kLeastLevel && region.falling >= kMostly * region.fading && region.flat_part >= kFlatPart;
}

/// Fades out on one side, and ends at edges of what is more opaque on the other, or stands alone.
bool is_shadow_of_body(const AlphaRegion& region) {
  return region.fading > kMostly * region.falling && region.rising >= region.merging;
}

/// By label.
std::vector<Kind> kinds_of(const AlphaRegions& parts, const cv::Mat& alpha, int unit_px) {
  std::vector<Kind> kinds(parts.regions.size(), Kind::as_opaque);
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    if (is_large(parts.regions[i], unit_px) && is_solid(parts.regions[i])) kinds[i] = Kind::solid;
  }
  const bool any_body =
      std::count(kinds.begin(), kinds.end(), Kind::solid) > 0 || cv::countNonZero(alpha >= kOpaqueAlpha) > 0;
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    if (!any_body || kinds[i] == Kind::solid || !is_large(parts.regions[i], unit_px)) continue;
    if (is_shadow_of_body(parts.regions[i])) kinds[i] = Kind::shadow;
  }
  return kinds;
}

/// Whether its outline is another one than that of alpha.
bool matters(const AlphaRegion& region, Kind kind) {
  if (kind == Kind::solid) return std::max(region.least, least_counted(region)) < kBarelyHalf;
  return kind == Kind::shadow && region.most >= kHalf;
}

/// Of each pixel the nearest one of some others.
class NearestPixels {
 public:
  /// `mask`: CV_8U, 255 where they are.
  NearestPixels(const cv::Mat& mask, const cv::Mat& alpha) : level_(std::size_t(cv::countNonZero(mask)) + 1, 0) {
    if (level_.size() == 1) {
      distance_px_ = cv::Mat(mask.size(), CV_32F, cv::Scalar(1e9));
      label_ = cv::Mat::zeros(mask.size(), CV_32S);
      return;
    }
    cv::distanceTransform(~mask, distance_px_, label_, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (mask.at<std::uint8_t>(y, x)) level_[std::size_t(label_.at<int>(y, x))] = alpha.at<std::uint8_t>(y, x);
      }
    }
  }

  double distance_px(int y, int x) const { return double(distance_px_.at<float>(y, x)); }
  /// Its alpha; 0 where there is none.
  int level(int y, int x) const { return level_[std::size_t(label_.at<int>(y, x))]; }

 private:
  cv::Mat distance_px_;     // CV_32F
  cv::Mat label_;           // CV_32S
  std::vector<int> level_;  // by label
};

/// CV_8U: what is opaque, what is translucent and counts, and what is left out.
struct SurePixels {
  cv::Mat opaque;
  cv::Mat translucent;
  cv::Mat left_out;
};

SurePixels sure_pixels(const cv::Mat& alpha, const AlphaRegions& parts, const std::vector<Kind>& kinds) {
  SurePixels sure{alpha >= kOpaqueAlpha, cv::Mat::zeros(alpha.size(), CV_8U), alpha < kClearAlpha};
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) {
      const Kind kind = kinds[std::size_t(parts.label.at<int>(y, x))];
      if (kind == Kind::shadow) sure.left_out.at<std::uint8_t>(y, x) = 255;
      const bool counts = kind == Kind::solid && alpha.at<std::uint8_t>(y, x) >= least_counted(parts.at(y, x));
      if (counts) sure.translucent.at<std::uint8_t>(y, x) = 255;
    }
  }
  return sure;
}

/// On edges, alpha as it rises from what is left out on one side to what counts on the other.
cv::Mat coverage_of(const cv::Mat& alpha, const AlphaRegions& parts, const SurePixels& sure, int unit_px) {
  const NearestPixels opaque(sure.opaque, alpha), translucent(sure.translucent, alpha), left_out(sure.left_out, alpha);
  const double reach_px = kEdgeWidth_px * unit_px;
  cv::Mat coverage = alpha.clone();
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) {
      if (parts.label.at<int>(y, x) != 0) continue;
      // Where both are near, the lower level: between a wing and its body nothing is left out.
      const double to_translucent_px = translucent.distance_px(y, x), to_opaque_px = opaque.distance_px(y, x);
      const bool by_wing = to_translucent_px <= std::min(reach_px, to_opaque_px + 2 * unit_px);
      const bool by_shadow = left_out.distance_px(y, x) <= reach_px && left_out.level(y, x) >= kClearAlpha;
      if (!by_wing && (!by_shadow || to_opaque_px > reach_px)) continue;
      const int top = by_wing ? translucent.level(y, x) : opaque.level(y, x);
      const int bottom = by_shadow ? std::min(left_out.level(y, x), top - 1) : 0;
      const double part = double(alpha.at<std::uint8_t>(y, x) - bottom) / (top - bottom);
      coverage.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(255 * part);
    }
  }
  coverage.setTo(255, sure.opaque | sure.translucent);
  coverage.setTo(0, sure.left_out & (alpha >= kClearAlpha));
  return coverage;
}

/// Translucent parts count with an opaque one that they touch; where there is none, all of them do.
void remove_loose_parts(cv::Mat& coverage, const cv::Mat& alpha) {
  cv::Mat label;
  const int count = cv::connectedComponents(coverage >= kHalf, label, 8, CV_32S);
  std::vector<bool> is_opaque(std::size_t(count), false);
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      const int part = label.at<int>(y, x);
      if (part > 0 && alpha.at<std::uint8_t>(y, x) >= kHalf) is_opaque[std::size_t(part)] = true;
    }
  }
  if (std::find(is_opaque.begin(), is_opaque.end(), true) == is_opaque.end()) return;
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      const int part = label.at<int>(y, x);
      if (part > 0 && !is_opaque[std::size_t(part)]) coverage.at<std::uint8_t>(y, x) = 0;
    }
  }
}

}  // namespace

cv::Mat solid_coverage(const cv::Mat& alpha, double source_px) {
  const int unit_px = std::max(1, int(std::lround(source_px)));
  const AlphaRegions parts = alpha_regions(alpha, unit_px);
  const std::vector<Kind> kinds = kinds_of(parts, alpha, unit_px);
  bool any_matters = false;
  for (std::size_t i = 1; i < kinds.size(); ++i) any_matters = any_matters || matters(parts.regions[i], kinds[i]);
  if (!any_matters) return alpha;
  cv::Mat coverage = coverage_of(alpha, parts, sure_pixels(alpha, parts, kinds), unit_px);
  remove_loose_parts(coverage, alpha);
  return coverage;
}

}  // namespace tessera::io
