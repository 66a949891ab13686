#include "core/replacing/window_cuts.h"

#include <algorithm>

namespace tessera {
namespace {

/// The edges of the windows along one axis, in ascending order.
std::vector<float> cuts_along(float low, float high, bool repeats, float least_px, float part) {
  const int windows = std::max(1, int((high - low) / least_px));
  const float step = (high - low) / float(windows);
  std::vector<float> cuts;
  if (repeats) {
    for (int k = 0; k <= windows; ++k) cuts.push_back(low + (float(k) + part) * step);
    return cuts;
  }
  cuts.push_back(low);
  for (int k = 1; k < windows; ++k) cuts.push_back(low + (float(k) + part - 0.5f) * step);
  cuts.push_back(high);
  return cuts;
}

}  // namespace

std::vector<Box> cut_into_windows(const Box& canvas, const Period& period, float least_px, float part_x, float part_y) {
  const std::vector<float> x = cuts_along(canvas.low.x, canvas.high.x, period.x_px > 0, least_px, part_x);
  const std::vector<float> y = cuts_along(canvas.low.y, canvas.high.y, period.y_px > 0, least_px, part_y);
  std::vector<Box> windows;
  for (std::size_t j = 0; j + 1 < y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) windows.push_back({{x[i], y[j]}, {x[i + 1], y[j + 1]}});
  }
  return windows;
}

}  // namespace tessera
