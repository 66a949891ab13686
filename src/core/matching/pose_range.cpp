#include "core/matching/pose_range.h"

namespace tessera {

DirectionRange direction_range(float min_rad, float max_rad) {
  const double width_rad = double(max_rad) - double(min_rad);
  const double middle_rad = 0.5 * (double(min_rad) + double(max_rad));
  DirectionRange range;
  range.middle = {float(std::cos(middle_rad)), float(std::sin(middle_rad))};
  if (width_rad < 6.283) range.edge = {float(std::cos(0.5 * width_rad)), float(std::sin(0.5 * width_rad))};
  return range;
}

}  // namespace tessera
