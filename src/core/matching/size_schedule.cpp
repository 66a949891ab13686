#include "core/matching/size_schedule.h"

#include <algorithm>
#include <cmath>

#include "core/settings/tuning.h"

namespace tessera {
namespace {

double needed_px2(const std::vector<WantedPieces>& pieces, double most_px) {
  double needed = 0;
  for (const auto& [s, count] : pieces) {
    needed += count * mean_square_px2(s.min, std::max<double>(s.min, std::min<double>(s.max, most_px)));
  }
  return needed;
}

}  // namespace

double mean_square_px2(double low_px, double high_px) {
  if (high_px < low_px * kNearlyOneSize) return low_px * high_px;
  return (high_px * high_px - low_px * low_px) / (2 * std::log(high_px / low_px));
}

float most_scale_px(double free_px2, const std::vector<WantedPieces>& left) {
  float least_px = 0;
  float most_px = 0;
  for (const auto& [s, count] : left) {
    least_px = std::max(least_px, s.min);
    most_px = std::max(most_px, s.max);
  }
  while (most_px > least_px && needed_px2(left, most_px) > kFilledByTheRest * free_px2) most_px *= kSizeStep;
  return std::max(least_px, most_px);
}

double size_factor(double area_px2, double part, const std::vector<WantedPieces>& pieces, double padding_px) {
  double needed_px2 = 0;  // at factor 1
  double sides_px = 0;
  double count = 0;
  for (const auto& [s, pieces_of_it] : pieces) {
    const double px2 = mean_square_px2(s.min, s.max) * (s.max < s.min * kNearlyOneSize ? 1 : kNearTheTop);
    needed_px2 += pieces_of_it * px2;
    sides_px += pieces_of_it * std::sqrt(px2);
    count += pieces_of_it;
  }
  if (needed_px2 <= 0) return 1;
  if (padding_px <= 0) return std::sqrt(part * area_px2 / needed_px2);
  // Treats all pieces as squares of their area: the side of each grows by the padding.
  const double half = padding_px * sides_px / needed_px2;
  const double left = (part * area_px2 - count * padding_px * padding_px) / needed_px2;
  return left > 0 ? std::sqrt(half * half + left) - half : 0;
}

}  // namespace tessera
