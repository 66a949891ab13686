// Bilinear look-up in a canvas field. kernels/field_lookup.cl does the same in OpenCL C, bit for bit.
#pragma once

#include "core/field/canvas.h"

namespace tessera {

/// The value off the grid: deep outside the region.
inline constexpr float kOffGridDistance = -60.f;

struct FieldView {
  const float* value = nullptr;
  int width = 0;
  int height = 0;
  Vec2 origin;

  FieldView() = default;
  explicit FieldView(const CanvasField& field)
      : value(field.value.data().data()),
        width(field.value.width()),
        height(field.value.height()),
        origin(field.origin) {}
};

struct FieldSample {
  float value;
  Vec2 gradient;
};

/// The field's value at `p`, canvas px.
inline float field_value(const FieldView& f, Vec2 p) {
  const float u = p.x - f.origin.x;
  const float v = p.y - f.origin.y;
  if (!(u >= 0 && v >= 0 && u < float(f.width - 1) && v < float(f.height - 1))) return kOffGridDistance;
  const int i = int(u);
  const int j = int(v);
  const float s = u - float(i);
  const float t = v - float(j);
  const float* q = f.value + (std::size_t(j) * f.width + i);
  return (q[0] * (1 - s) + q[1] * s) * (1 - t) + (q[f.width] * (1 - s) + q[f.width + 1] * s) * t;
}

/// The value and its gradient. Off the grid the gradient points back to the middle, so that a pose outside is pulled
/// in.
inline FieldSample field_sample(const FieldView& f, Vec2 p) {
  const float u = p.x - f.origin.x;
  const float v = p.y - f.origin.y;
  if (!(u >= 0 && v >= 0 && u < float(f.width - 1) && v < float(f.height - 1))) {
    return {kOffGridDistance, {u < float(f.width) * 0.5f ? 1.f : -1.f, v < float(f.height) * 0.5f ? 1.f : -1.f}};
  }
  const int i = int(u);
  const int j = int(v);
  const float s = u - float(i);
  const float t = v - float(j);
  const float* q = f.value + (std::size_t(j) * f.width + i);
  const float* r = q + f.width;
  return {(q[0] * (1 - s) + q[1] * s) * (1 - t) + (r[0] * (1 - s) + r[1] * s) * t,
          {(q[1] - q[0]) * (1 - t) + (r[1] - r[0]) * t, (r[0] - q[0]) * (1 - s) + (r[1] - q[1]) * s}};
}

}  // namespace tessera
