#include "render/ground_continuation.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "artwork/nearest_pixels.h"
#include "core/base/portable_math.h"

namespace tessera {
namespace {

constexpr float kContinued_px = 12;
/// Grains come from so near the edge of the ground.
constexpr int kGrain_px = 5;
constexpr std::uint64_t kMostDraws = 8;
/// Single pixels would be sharper than the photo.
constexpr double kGrainBlur_px = 0.7;
constexpr int kBlurReach_px = 3;
static_assert(int(kContinued_px) + kGrain_px + kBlurReach_px <= kContinuation_px);

cv::Mat alpha_of(const cv::Mat& pixels) {
  cv::Mat alpha;
  cv::extractChannel(pixels, alpha, 3);
  return alpha;
}

/// A pixel of the ground near `edge`, which is one itself, drawn by the way from there to the place that it is for. So the
/// same gap looks the same wherever it lies on the canvas.
cv::Point drawn_ground(const cv::Mat& is_ground, cv::Point edge, cv::Point way) {
  const std::uint64_t key = mix_bits(std::uint64_t(std::uint32_t(way.y)) << 32 | std::uint32_t(way.x));
  const cv::Rect inside({}, is_ground.size());
  constexpr std::uint64_t kSide_px = 2 * kGrain_px + 1;
  for (std::uint64_t draw = 0; draw < kMostDraws; ++draw) {
    const std::uint64_t bits = mix_bits(key + draw);
    const cv::Point at = edge + cv::Point(int(bits % kSide_px) - kGrain_px, int((bits >> 32) % kSide_px) - kGrain_px);
    if (inside.contains(at) && is_ground.at<std::uint8_t>(at)) return at;
  }
  return edge;
}

}  // namespace

void continue_ground(const cv::Mat& is_piece, cv::Mat& pixels) {
  const cv::Mat is_shown = alpha_of(pixels) > 0, is_ground = is_shown & ~is_piece;
  const NearestPixels ground(is_ground);
  cv::Mat is_new = cv::Mat::zeros(pixels.size(), CV_8U);
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      if (is_shown.at<std::uint8_t>(y, x) || ground.distance_px({x, y}) > kContinued_px) continue;
      const cv::Point edge = *ground.nearest({x, y}), from = drawn_ground(is_ground, edge, cv::Point(x, y) - edge);
      pixels.at<cv::Vec4b>(y, x) = pixels.at<cv::Vec4b>(from);
      is_new.at<std::uint8_t>(y, x) = 255;
    }
  }
  soften(is_new, pixels);
}

void soften(const cv::Mat& which, cv::Mat& pixels) {
  cv::Mat soft;
  cv::GaussianBlur(pixels, soft, {2 * kBlurReach_px + 1, 2 * kBlurReach_px + 1}, kGrainBlur_px);
  soft.copyTo(pixels, which & (alpha_of(soft) == 255));
}

}  // namespace tessera
