#include "bench/scenes/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace tessera::bench {
namespace {

constexpr int kBisections = 24;  // finer than a pixel

double area_px2(const cv::Mat& mask) { return double(cv::countNonZero(mask)); }

double hidden_part(const cv::Mat& lower, const cv::Mat& hider) {
  cv::Mat both;
  cv::bitwise_and(lower, hider, both);
  return area_px2(both) / area_px2(lower);
}

cv::Point2d centroid(const cv::Mat& mask) {
  const cv::Moments m = cv::moments(mask, true);
  return {m.m10 / m.m00, m.m01 / m.m00};
}

/// A silhouette laid over another one: turned and scaled about its centroid, which is placed at a point of the scene.
class LaidOver {
 public:
  LaidOver(const cv::Mat& mask, double turned_rad, double size)
      : mask_(mask),
        a_(std::cos(turned_rad) * size),
        b_(std::sin(turned_rad) * size),
        centre_(centroid(mask)) {}

  cv::Mat at(cv::Point2d place, cv::Size scene) const {
    const double tx = place.x - (a_ * centre_.x - b_ * centre_.y);
    const double ty = place.y - (b_ * centre_.x + a_ * centre_.y);
    const cv::Mat matrix = (cv::Mat_<double>(2, 3) << a_, -b_, tx, b_, a_, ty);
    cv::Mat laid;
    cv::warpAffine(mask_, laid, matrix, scene, cv::INTER_LINEAR);
    return laid > 127;
  }

 private:
  const cv::Mat& mask_;
  double a_, b_;
  cv::Point2d centre_;
};

}  // namespace

cv::Mat Scene::seen() const {
  cv::Mat seen = lower.clone();
  seen.setTo(0, hider);
  return seen;
}

cv::Mat Scene::united() const {
  cv::Mat both;
  cv::bitwise_or(lower, hider, both);
  return both;
}

double Scene::hidden() const { return hidden_part(lower, hider); }

Scene clipped_scene(const cv::Mat& lower, double hidden) {
  const cv::Rect box = cv::boundingRect(lower);
  cv::Mat hider(lower.size(), CV_8U, cv::Scalar(0));
  hider.colRange(0, std::min(lower.cols, int(std::lround(box.x + hidden * box.width)))).setTo(255);
  return {lower, hider};
}

std::optional<Scene> covered_scene(const cv::Mat& lower, const cv::Mat& upper, double hidden, double times_as_large,
                                   Draws& draws) {
  const double turned_rad = 2 * std::numbers::pi * double(draws.unit());
  const double away_rad = 2 * std::numbers::pi * double(draws.unit());
  const double size = std::sqrt(times_as_large * area_px2(lower) / area_px2(upper));
  const double upper_diagonal_px = size * std::hypot(upper.cols, upper.rows);

  const LaidOver laid(upper, turned_rad, size);
  const cv::Point2d start = centroid(lower);
  const cv::Point2d direction(std::cos(away_rad), std::sin(away_rad));
  const auto hides_enough = [&](double away_px) {
    return hidden_part(lower, laid.at(start + direction * away_px, lower.size())) >= hidden;
  };
  if (!hides_enough(0)) return std::nullopt;
  double near_px = 0;
  double far_px = upper_diagonal_px + std::hypot(lower.cols, lower.rows);
  for (int step = 0; step < kBisections; ++step) {
    const double middle_px = (near_px + far_px) / 2;
    (hides_enough(middle_px) ? near_px : far_px) = middle_px;
  }

  const int room_px = int(upper_diagonal_px) + 1;
  Scene scene;
  cv::copyMakeBorder(lower, scene.lower, room_px, room_px, room_px, room_px, cv::BORDER_CONSTANT, 0);
  const cv::Point2d place = start + direction * near_px + cv::Point2d(room_px, room_px);
  scene.hider = laid.at(place, scene.lower.size());
  const cv::Rect box = cv::boundingRect(scene.united());
  const cv::Rect all(0, 0, scene.lower.cols, scene.lower.rows);
  const cv::Rect kept = (box - cv::Point(1, 1) + cv::Size(2, 2)) & all;
  return Scene{scene.lower(kept).clone(), scene.hider(kept).clone()};
}

HiderDistance distance_from_hider(const Scene& scene) {
  cv::Mat distance;  // from the centre of each pixel to the nearest hidden one
  cv::distanceTransform(scene.hider == 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return [distance](Vec2 p) {
    const int x = std::clamp(int(std::lround(p.x)), 0, distance.cols - 1);
    const int y = std::clamp(int(std::lround(p.y)), 0, distance.rows - 1);
    return double(distance.at<float>(y, x)) - 0.5;
  };
}

}  // namespace tessera::bench
