#include "core/style/style_features.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

/// Fraction of the area from which on a drawing counts as drawn with lines; below it lines count in proportion.
constexpr double kDrawnWithLines = 0.05;
/// Shape units. Widths are compared by their ratio, those of hairlines by their difference.
constexpr double kFineLine = 0.005;

/// One unit of distance for each feature: about its spread over Debian's clip art (docs/decisions/2026-11-24-distance-of-styles.md), in
/// round numbers. A larger value gives a feature less weight, as for `outlined`: a part of the boundary is enough to
/// look outlined.
struct Spread {
  double line_width = 0.6;  // of the logarithm
  double line_part = 0.3;   // of the square root, as for texture
  double outlined = 0.8;
  double palette_bits = 1;
  double chroma = 14;
  double texture = 0.25;
  double shading = 0.3;
  double detail = 0.4;
};
constexpr Spread kSpread;

}  // namespace

StylePlace style_place(const StyleFeatures& f) {
  const double lines = std::min(1., double(f.line_part) / kDrawnWithLines);
  const double width = portable_log(1 + double(f.line_width) / kFineLine);
  return {float(lines * width / kSpread.line_width),    float(std::sqrt(double(f.line_part)) / kSpread.line_part),
          float(double(f.outlined) / kSpread.outlined), float(double(f.palette) / kSpread.palette_bits),
          float(double(f.chroma) / kSpread.chroma),     float(std::sqrt(double(f.texture)) / kSpread.texture),
          float(double(f.shading) / kSpread.shading),   float(double(f.detail) / kSpread.detail)};
}

float style_distance(const StylePlace& a, const StylePlace& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace tessera
