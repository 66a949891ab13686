#include "core/colour/ssim.h"

#include <algorithm>

namespace tessera {
namespace {

// Constants that keep the quotients finite, for greys from 0 to 255.
constexpr double kLuminance = (0.01 * 255) * (0.01 * 255);
constexpr double kContrast = (0.03 * 255) * (0.03 * 255);

struct WindowMoments {
  double weight = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
};

WindowMoments moments_in(const Window& window, const Grid<float>& x, const Grid<float>& y, const Grid<float>& weight) {
  WindowMoments sum;
  for (int row = window.y0; row < window.y1; ++row) {
    for (int column = window.x0; column < window.x1; ++column) {
      const double w = double(weight(column, row)), a = double(x(column, row)), b = double(y(column, row));
      sum.weight += w;
      sum.x += w * a;
      sum.y += w * b;
      sum.xx += w * a * a;
      sum.yy += w * b * b;
      sum.xy += w * a * b;
    }
  }
  return sum;
}

double similarity(const WindowMoments& sum, int pixels) {
  const double x = sum.x / sum.weight, y = sum.y / sum.weight;
  const double unbiased = pixels > 1 ? double(pixels) / (pixels - 1) : 1;
  const double variance_x = unbiased * (sum.xx / sum.weight - x * x);
  const double variance_y = unbiased * (sum.yy / sum.weight - y * y);
  const double covariance = unbiased * (sum.xy / sum.weight - x * y);
  return (2 * x * y + kLuminance) * (2 * covariance + kContrast) /
         ((x * x + y * y + kLuminance) * (variance_x + variance_y + kContrast));
}

}  // namespace

double ssim(const Grid<float>& x, const Grid<float>& y, const Grid<float>& weight) {
  const int width = std::min(kSsimWindow_px, x.width()), height = std::min(kSsimWindow_px, x.height());
  double sum = 0, weights = 0;
  for (int top = 0; top + height <= x.height(); ++top) {
    for (int left = 0; left + width <= x.width(); ++left) {
      const WindowMoments moments = moments_in({left, top, left + width, top + height}, x, y, weight);
      if (!(moments.weight > 0)) continue;
      sum += moments.weight * similarity(moments, width * height);
      weights += moments.weight;
    }
  }
  return weights > 0 ? sum / weights : 1;
}

}  // namespace tessera
