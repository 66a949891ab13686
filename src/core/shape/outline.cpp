#include "core/shape/outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/geometry/closed_curve.h"
#include "core/geometry/contour.h"
#include "core/geometry/distance_transform.h"
#include "core/geometry/polygon.h"
#include "core/geometry/rasterise.h"

namespace tessera {
namespace {

constexpr double kBarAspect = 4;
constexpr float kOpeningCells = 4.2f;  // radius in cells of the disc that finds hairlines: round enough, and fast

struct Component {
  Outline outline;
  double outer_area = 0;
  double covered_area = 0;  // the enclosed area without holes
  int others = 0;
  double others_area = 0;
};

/// Index of the smallest outer curve around hole `hole`. Only curves larger than the hole are considered.
std::size_t owner_of(std::size_t hole, const std::vector<std::vector<Vec2>>& curves, const std::vector<double>& area,
                     std::size_t largest) {
  std::size_t owner = largest;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool may_hold = area[i] > -area[hole] && area[i] < area[owner];
    if (may_hold && contains(curves[i], curves[hole].front())) owner = i;
  }
  return owner;
}

/// The component whose outer curve encloses the largest area, with the holes that count.
Component largest_component(const std::vector<std::vector<Vec2>>& curves, bool fill_holes) {
  std::vector<double> area(curves.size());
  std::transform(curves.begin(), curves.end(), area.begin(), signed_area);
  const std::size_t largest = std::size_t(std::max_element(area.begin(), area.end()) - area.begin());

  Component component;
  component.outer_area = component.covered_area = area[largest];
  component.outline.curves.push_back(curves[largest]);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (area[i] > 0 && i != largest && !(fill_holes && contains(curves[largest], curves[i].front()))) {
      ++component.others;
      component.others_area += area[i];
    }
    if (area[i] >= -kLeastHole * area[largest] || !contains(curves[largest], curves[i].front())) continue;
    if (owner_of(i, curves, area, largest) != largest) continue;
    component.covered_area += area[i];
    if (!fill_holes) component.outline.curves.push_back(curves[i]);
  }
  return component;
}

double enclosed_area(const Outline& outline) {
  return std::accumulate(outline.curves.begin(), outline.curves.end(), 0.0,
                         [](double sum, const std::vector<Vec2>& curve) { return sum + signed_area(curve); });
}

/// A long bar may lack no more area than one of aspect `kBarAspect`, so that its length does not hide missing ends.
bool is_plain_rectangle(const Outline& outline) {
  const Box box = bounding_box(outline.curves.front());
  const double width = std::min(box.width(), box.height()), length = std::max(box.width(), box.height());
  const double lacking = width * length - enclosed_area(outline);
  return lacking <= (1 - kPlainRectangle) * width * std::min(length, kBarAspect * width);
}

std::ptrdiff_t count_set(const Grid<std::uint8_t>& set) { return std::count(set.data().begin(), set.data().end(), 1); }

template <class Keep>
Grid<std::uint8_t> nodes_where(const Grid<float>& squared_distance, Keep keep) {
  Grid<std::uint8_t> set(squared_distance.width(), squared_distance.height());
  std::transform(squared_distance.data().begin(), squared_distance.data().end(), set.data().begin(),
                 [&](float d2) { return std::uint8_t(keep(d2)); });
  return set;
}

/// Morphological opening: the area that a disc of this radius covers without leaving the set.
Grid<std::uint8_t> opened(const Grid<std::uint8_t>& set, float radius) {
  Grid<std::uint8_t> outside = set;
  for (std::uint8_t& v : outside.data()) v ^= 1;
  const float r2 = radius * radius;
  const Grid<std::uint8_t> eroded = nodes_where(squared_distance_to(outside), [&](float d2) { return d2 > r2; });
  return nodes_where(squared_distance_to(eroded), [&](float d2) { return d2 <= r2; });
}

bool is_hairlines(const Outline& outline, double area) {
  const Box box = bounding_box(outline.curves.front());
  if (std::max(box.width(), box.height()) > kLongest * std::sqrt(area)) return true;
  const float cells_per_px = kOpeningCells / (kHairlineRadius * float(std::sqrt(area)));
  const Similarity cells_from_px{cells_per_px, 0, 0, 0};
  const Window window = bounding_window(outline, cells_from_px).grown(1);  // the rim is outside
  const Grid<std::uint8_t> set = rasterise(outline, cells_from_px, window);
  return double(count_set(opened(set, kOpeningCells))) < kHairlineRest * double(count_set(set));
}

double length_of(const std::vector<Vec2>& closed) {
  double length = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) length += double(norm(closed[(i + 1) % closed.size()] - closed[i]));
  return length;
}

/// The reason why a drawing with several parts is skipped. A line thinner than a pixel breaks into fragments when it is
/// drawn in pixels. These look like parts, but the reason is the thin line.
SkipReason reason_for_parts(const Outline& parts, float source_px) {
  double length = 0;
  for (const std::vector<Vec2>& curve : parts.curves) length += length_of(curve);
  const double mean_width_px = 2 * enclosed_area(parts) / length;
  return mean_width_px < std::max(1.f, source_px) ? SkipReason::hairlines : SkipReason::several_large_components;
}

std::optional<SkipReason> reason_to_skip(const Component& component, float source_px, const TracingRules& rules) {
  const double area = enclosed_area(component.outline);
  // Hairlines come first: pixels show only fragments of thin lines, which would seem too small.
  if (is_hairlines(component.outline, area)) return SkipReason::hairlines;
  if (std::sqrt(area) < kLeastSize_px * std::max(1.f, source_px)) return SkipReason::too_small;
  if (!rules.keep_rectangles && is_plain_rectangle(component.outline)) return SkipReason::plain_rectangle;
  return std::nullopt;
}

}  // namespace

std::variant<TracedOutline, SkipReason> trace_outline(const Grid<float>& alpha, Vec2 origin_px, float source_px,
                                                      const TracingRules& rules) {
  std::vector<std::vector<Vec2>> curves = contours(alpha, rules.edge_opacity);
  if (curves.empty()) return SkipReason::empty;
  Component component = largest_component(curves, rules.fill_holes);
  if (component.others_area > kLargestSpecks * component.outer_area) {
    return reason_for_parts({std::move(curves)}, source_px);
  }
  if (const auto reason = reason_to_skip(component, source_px, rules)) return *reason;

  const float sigma_px = std::max(kSmoothing_px, kSmoothing_sourcepx * source_px);
  TracedOutline traced;
  traced.other_components = component.others;
  traced.other_area_fraction = float(component.others_area / component.outer_area);
  traced.hollowness = float(component.outer_area / component.covered_area);
  for (std::vector<Vec2>& curve : component.outline.curves) {
    for (Vec2& p : curve) p = p + origin_px + Vec2{0.5f, 0.5f};
    traced.curves.push_back(smoothing_spline(curve, sigma_px));
  }
  return traced;
}

float perimeter_of(const Outline& outline) {
  float perimeter = 0;
  for (const std::vector<Vec2>& curve : outline.curves) perimeter += closed_length(curve);
  return perimeter;
}

}  // namespace tessera
