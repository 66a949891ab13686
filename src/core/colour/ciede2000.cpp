#include "core/colour/ciede2000.h"

#include <cmath>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

/// c^7 / (c^7 + 25^7).
float saturation(float chroma) {
  const float c2 = chroma * chroma;
  const float c7 = c2 * c2 * c2 * chroma;
  return c7 / (c7 + 6103515625.f);
}

struct Direction {
  float cosine;
  float sine;
};

/// The direction of the middle between two hues; a grey has no hue and does not count.
Direction middle_hue(float ax, float bx, float chroma_x, float ay, float by, float chroma_y) {
  const float inverse_x = chroma_x > 0 ? 1 / chroma_x : 0.f;
  const float inverse_y = chroma_y > 0 ? 1 / chroma_y : 0.f;
  const float u = ax * inverse_x + ay * inverse_y;
  const float v = bx * inverse_x + by * inverse_y;
  const float length = std::sqrt(u * u + v * v);
  if (!(length > 1e-6f)) return {1, 0};
  return {u / length, v / length};
}

/// T: 1 - 0.17 cos(h - 30°) + 0.24 cos 2h + 0.32 cos(3h + 6°) - 0.2 cos(4h - 63°).
float hue_weight(Direction h) {
  const float cos2 = 2 * h.cosine * h.cosine - 1;
  const float sin2 = 2 * h.cosine * h.sine;
  const float cos3 = h.cosine * cos2 - h.sine * sin2;
  const float sin3 = h.sine * cos2 + h.cosine * sin2;
  const float cos4 = 2 * cos2 * cos2 - 1;
  const float sin4 = 2 * cos2 * sin2;
  return 1 - 0.17f * (h.cosine * 0.86602540f + h.sine * 0.5f) + 0.24f * cos2 +
         0.32f * (cos3 * 0.99452190f - sin3 * 0.10452846f) - 0.2f * (cos4 * 0.45399050f + sin4 * 0.89100652f);
}

/// sin(60° e^(-((h - 275°) / 25°)^2)): the rotation of the ellipses among the blues.
float blue_turn(Direction h) {
  const float along = h.cosine * 0.08715574f - h.sine * 0.99619470f;  // cos(h - 275°)
  const float u = 1 - (along > 0 ? along : 0.f);                      // zero beyond a right angle
  // (h - 275°)^2 in rad²: 4 asin(sqrt(u / 2))^2 as a series.
  float square = 3.8480038e-3f;
  square = square * u + 1.01587302e-2f;
  square = square * u + 2.85714286e-2f;
  square = square * u + 8.88888889e-2f;
  square = square * u + 3.33333333e-1f;
  square = square * u + 2.f;
  square = square * u;
  const float x = 1.04719755f * portable_exp2(square * -7.5777466f);  // (180 / (25 pi))^2 / ln 2
  const float x2 = x * x;
  return x * (1 - x2 * (0.16666667f - x2 * (8.3333333e-3f - x2 * 1.9841270e-4f)));
}

}  // namespace

float ciede2000(const Lab& x, const Lab& y) {
  const float drawn_chroma = (std::sqrt(x.a * x.a + x.b * x.b) + std::sqrt(y.a * y.a + y.b * y.b)) * 0.5f;
  const float more_a = 0.5f - 0.5f * std::sqrt(saturation(drawn_chroma));
  const float ax = x.a + x.a * more_a;
  const float ay = y.a + y.a * more_a;
  const float chroma_x = std::sqrt(ax * ax + x.b * x.b);
  const float chroma_y = std::sqrt(ay * ay + y.b * y.b);
  const float chroma = (chroma_x + chroma_y) * 0.5f;

  // The squared difference in hue is 2 (|x| |y| - x y). If that is a small difference of large numbers, the cross
  // product gives it.
  const float along = ax * ay + x.b * y.b;
  const float across = ax * y.b - x.b * ay;
  const float product = chroma_x * chroma_y;
  const float square = along > 0 ? 2 * (across * across) / (product + along) : 2 * (product - along);
  const float size = std::sqrt(square > 0 ? square : 0.f);
  const Direction h = middle_hue(ax, x.b, chroma_x, ay, y.b, chroma_y);

  const float off_middle = (x.lightness + y.lightness) * 0.5f - 50;
  const float off_middle2 = off_middle * off_middle;
  const float by_lightness = (y.lightness - x.lightness) / (1 + 0.015f * off_middle2 / std::sqrt(20 + off_middle2));
  const float by_chroma = (chroma_y - chroma_x) / (1 + 0.045f * chroma);
  const float by_hue = (across < 0 ? -size : size) / (1 + 0.015f * chroma * hue_weight(h));
  const float turn = -2 * std::sqrt(saturation(chroma)) * blue_turn(h);
  const float sum = by_lightness * by_lightness + by_chroma * by_chroma + by_hue * by_hue + turn * (by_chroma * by_hue);
  return std::sqrt(sum > 0 ? sum : 0.f);
}

}  // namespace tessera
