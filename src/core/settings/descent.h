// How a pose is drawn onto the free region's boundary.
#pragma once

namespace tessera {

/// One descent: `steps` Gauss-Newton steps that draw boundary points nearer than a radius (shrinking from
/// `first_radius_px` to `last_radius_px`) onto the free region's boundary; a point outside weighs `overlap_weight`.
struct Descent {
  int steps;
  float first_radius_px;
  float last_radius_px;
  float overlap_weight;
  bool all_points;  // else every second boundary point
};

}  // namespace tessera
