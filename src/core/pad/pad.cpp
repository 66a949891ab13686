#include "core/pad/pad.h"

#include <algorithm>
#include <cmath>

namespace tessera {

Pad make_pad(const ArclengthPyramid& pyramid, int levels) {
  Pad pad;
  const int top = levels - 1;
  float weight = 1;
  for (int i = 0; i < top; ++i, weight *= 0.5f) {
    pad.element[top - 1 - i] = weight * pyramid.left[i] / pyramid.left[top];
    pad.element[top + i] = weight * pyramid.right[i] / pyramid.right[top];
  }
  pad.convexity = pyramid.convexity;
  return pad;
}

float pad_distance(const Pad& p, const Pad& q, int levels) {
  float distance = 0;
  // A flat point (0) agrees with both signs: its triangle is below the noise.
  const float relative_sign = p.convexity * q.convexity < 0 ? -1.f : 1.f;
  for (int i = 0; i < 2 * (levels - 1); ++i) {
    distance = std::max(distance, std::abs(p.element[i] - relative_sign * q.element[i]));
  }
  return distance;
}

Pad flipped(const Pad& pad, int levels) {
  Pad result = pad;
  std::reverse(result.element.begin(), result.element.begin() + 2 * (levels - 1));
  result.convexity = -pad.convexity;
  return result;
}

}  // namespace tessera
