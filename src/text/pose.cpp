#include "text/pose.h"

#include <cmath>
#include <numbers>

namespace tessera {

Similarity pose_of(double scale_px, double rotation_deg, double x_px, double y_px) {
  const double rotation_rad = rotation_deg * std::numbers::pi / 180;
  return {float(scale_px * std::cos(rotation_rad)), float(scale_px * std::sin(rotation_rad)), float(x_px), float(y_px)};
}

double rotation_deg(const Similarity& canvas_from_shape) {
  return double(canvas_from_shape.rotation_rad()) * 180 / std::numbers::pi;
}

}  // namespace tessera
