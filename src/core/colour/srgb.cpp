#include "core/colour/srgb.h"

#include <cmath>

namespace tessera {
namespace {

/// The linear light of a coded value.
double light_of(float coded) {
  const double value = double(coded) / 255;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// CIELAB's cube root; near black it is linear.
double root_of(double part) {
  constexpr double kKnee = 6. / 29;
  return part > kKnee * kKnee * kKnee ? std::cbrt(part) : part / (3 * kKnee * kKnee) + 4. / 29;
}

}  // namespace

Lab lab_from_srgb(const Srgb& colour) {
  const double red = light_of(colour.red), green = light_of(colour.green), blue = light_of(colour.blue);
  // X, Y and Z relative to white.
  const double x = root_of((0.412453 * red + 0.357580 * green + 0.180423 * blue) / 0.950456);
  const double y = root_of(0.212671 * red + 0.715160 * green + 0.072169 * blue);
  const double z = root_of((0.019334 * red + 0.119193 * green + 0.950227 * blue) / 1.088754);
  return {float(116 * y - 16), float(500 * (x - y)), float(200 * (y - z))};
}

float grey_of(const Srgb& colour) { return 0.299f * colour.red + 0.587f * colour.green + 0.114f * colour.blue; }

}  // namespace tessera
