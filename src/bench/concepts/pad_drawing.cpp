#include "bench/concepts/pad_drawing.h"

#include <algorithm>

namespace tessera::bench::concepts {
namespace {

double length_of(const std::vector<Vec2>& closed_curve) {
  double length = 0;
  for (std::size_t i = 0; i < closed_curve.size(); ++i)
    length += double(norm(closed_curve[(i + 1) % closed_curve.size()] - closed_curve[i]));
  return length;
}

/// The points of the curve from so far before the point `at` to so far after it.
std::vector<Vec2> part_round(const std::vector<Vec2>& curve, std::size_t at, double before, double after) {
  const std::size_t n = curve.size();
  const double spacing = length_of(curve) / double(n);
  const std::size_t back = std::min(n / 2, std::size_t(before / spacing + 0.5));
  const std::size_t on = std::min(n / 2, std::size_t(after / spacing + 0.5));
  std::vector<Vec2> part;
  for (std::size_t i = 0; i <= back + on; ++i) part.push_back(curve[(at + n - back + i) % n]);
  return part;
}

}  // namespace

void draw_pad_levels(FigureSheet& sheet, const Similarity& sheet_from_curve, const std::vector<Vec2>& curve,
                     std::size_t at, const ArclengthPyramid& pyramid, int levels) {
  constexpr double kLevelWidth_px = 3.5;  // that each longer level is broader
  for (int level = levels - 1; level >= 0; --level) {
    const std::vector<Vec2> part =
        part_round(curve, at, double(pyramid.left[std::size_t(level)]), double(pyramid.right[std::size_t(level)]));
    sheet.open(applied(sheet_from_curve, part),
               {.stroke = kLevelColours[std::size_t(level)], .width_px = kLevelWidth_px * (level + 1)});
  }
  sheet.dot(sheet_from_curve.apply(curve[at]), 4.5, kOrange);
}

float least_element(const Pad& pad, int levels) {
  return *std::min_element(pad.element.begin(), pad.element.begin() + 2 * (levels - 1));
}

void draw_pad_bars(FigureSheet& sheet, const Box& box, const Pad& pad, int levels) {
  const int elements = 2 * (levels - 1);
  const bool concave = pad.convexity < 0;
  const float zero = concave ? box.low.y : box.high.y;
  const float full = concave ? box.height() : -box.height();
  const float step = box.width() / float(elements);
  for (int i = 0; i < elements; ++i) {
    const int level = i < levels - 1 ? levels - 2 - i : i - (levels - 1);
    const float left = box.low.x + step * (float(i) + 0.12f);
    const float end = zero + pad.element[std::size_t(i)] * full;
    sheet.box({{left, std::min(zero, end)}, {left + 0.76f * step, std::max(zero, end)}},
              {.fill = kLevelColours[std::size_t(level)]});
  }
  sheet.open({{box.low.x, zero}, {box.high.x, zero}}, {.stroke = kInk});
}

}  // namespace tessera::bench::concepts
