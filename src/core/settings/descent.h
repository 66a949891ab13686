// Parameters of a descent: the Gauss-Newton steps that pull a pose onto the free region's boundary.
#pragma once

namespace tessera {

/// One descent: `steps` Gauss-Newton steps that pull boundary points onto the free region's boundary. A step uses the
/// points nearer to it than a radius, which shrinks from `first_radius_px` to `last_radius_px`. A point outside the
/// free region weighs `overlap_weight`.
struct Descent {
  int steps;
  float first_radius_px;
  float last_radius_px;
  float overlap_weight;
  bool all_points;  // false: every second boundary point
};

}  // namespace tessera
