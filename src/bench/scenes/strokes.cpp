// Fences and branches over silhouettes (scene.h). Each is a field: how wide its strokes must be, as a multiple of their
// own widths, to reach a pixel. Pixels are hidden where the field is below the quantile for the wanted part of the
// area.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "bench/scenes/scene.h"
#include "core/geometry/vec2.h"

namespace tessera::bench {
namespace {

constexpr std::size_t kFewestBars = 2;
constexpr std::size_t kMostBars = 6;
/// The branch: number of generations and twigs; lengths and widths relative to the parent stroke.
constexpr int kGenerations = 3;
constexpr int kTwigs = 4;
constexpr float kTwigLength = 0.5f;
constexpr float kTwigWidth = 0.5f;
constexpr float kLeastTurn_rad = 0.5f;
constexpr float kMostTurn_rad = 1.1f;

using Field = std::function<float(Vec2)>;

/// Hides the pixels with the lowest field: this part of the silhouette's pixels, and all others as low.
Scene hidden_where_lowest(const cv::Mat& lower, double hidden, const Field& field) {
  cv::Mat values(lower.size(), CV_32F);
  std::vector<float> inside;
  for (int y = 0; y < lower.rows; ++y) {
    for (int x = 0; x < lower.cols; ++x) {
      const float value = field({float(x), float(y)});
      values.at<float>(y, x) = value;
      if (lower.at<std::uint8_t>(y, x)) inside.push_back(value);
    }
  }
  const auto count = std::size_t(std::lround(hidden * double(inside.size())));
  if (count == 0) return {lower, cv::Mat(lower.size(), CV_8U, cv::Scalar(0))};
  std::nth_element(inside.begin(), inside.begin() + std::ptrdiff_t(count - 1), inside.end());
  return {lower, values <= double(inside[count - 1])};
}

struct Stroke {
  Vec2 from;
  Vec2 to;
  float width = 1;
};

float distance_from(const Stroke& stroke, Vec2 p) {
  const Vec2 along = stroke.to - stroke.from;
  const float t = std::clamp(dot(p - stroke.from, along) / dot(along, along), 0.f, 1.f);
  return norm(p - (stroke.from + along * t));
}

Vec2 direction(float angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

/// Adds a stroke from a point on, with twigs alternately on the left and the right.
void grow(Vec2 from, float angle_rad, float length, float width, int generation, Draws& draws,
          std::vector<Stroke>& strokes) {
  const Vec2 to = from + direction(angle_rad) * length;
  strokes.push_back({from, to, width});
  if (generation == kGenerations) return;
  float side = draws.unit() < 0.5f ? -1 : 1;
  for (int twig = 1; twig <= kTwigs; ++twig, side = -side) {
    const float at = (float(twig) - 0.5f * draws.unit()) / float(kTwigs);
    const float turn_rad = kLeastTurn_rad + (kMostTurn_rad - kLeastTurn_rad) * draws.unit();
    grow(from + (to - from) * at, angle_rad + side * turn_rad, kTwigLength * length, kTwigWidth * width, generation + 1,
         draws, strokes);
  }
}

Vec2 middle_of(const cv::Rect& box) {
  return {float(box.x) + float(box.width) / 2, float(box.y) + float(box.height) / 2};
}

}  // namespace

Scene bars_scene(const cv::Mat& lower, double hidden, Draws& draws) {
  const cv::Rect box = cv::boundingRect(lower);
  const float angle_rad = std::numbers::pi_v<float> * draws.unit();
  const Vec2 across = direction(angle_rad);
  const float breadth = std::abs(across.x) * float(box.width) + std::abs(across.y) * float(box.height);
  const float pitch = breadth / float(kFewestBars + draws.below(kMostBars - kFewestBars + 1));
  const float shift = pitch * draws.unit();
  return hidden_where_lowest(lower, hidden, [=, middle = middle_of(box)](Vec2 p) {
    const float at = (dot(p - middle, across) + shift) / pitch;
    return std::abs(at - std::round(at));
  });
}

Scene branch_scene(const cv::Mat& lower, double hidden, Draws& draws) {
  const cv::Rect box = cv::boundingRect(lower);
  const float diagonal = std::hypot(float(box.width), float(box.height));
  const float angle_rad = 2 * std::numbers::pi_v<float> * draws.unit();
  const Vec2 sideways =
      direction(angle_rad + std::numbers::pi_v<float> / 2) * (0.3f * diagonal * (draws.unit() - 0.5f));
  std::vector<Stroke> strokes;
  grow(middle_of(box) + sideways - direction(angle_rad) * (diagonal / 2), angle_rad, diagonal, 1, 1, draws, strokes);
  return hidden_where_lowest(lower, hidden, [&](Vec2 p) {
    float least = std::numeric_limits<float>::infinity();
    for (const Stroke& stroke : strokes) least = std::min(least, distance_from(stroke, p) / stroke.width);
    return least;
  });
}

}  // namespace tessera::bench
