#include "core/matching/size_schedule.h"

#include <algorithm>
#include <cmath>

#include "core/tuning.h"

namespace tessera {
namespace {

double needed_px2(const std::vector<Interval>& shapes, double most_px) {
  double needed = 0;
  for (const Interval& s : shapes) {
    needed += mean_square_px2(s.min, std::max<double>(s.min, std::min<double>(s.max, most_px)));
  }
  return needed;
}

}  // namespace

double mean_square_px2(double low_px, double high_px) {
  if (high_px < low_px * kNearlyOneSize) return low_px * high_px;
  return (high_px * high_px - low_px * low_px) / (2 * std::log(high_px / low_px));
}

float most_scale_px(double free_px2, const std::vector<Interval>& left) {
  float least_px = 0;
  float most_px = 0;
  for (const Interval& s : left) {
    least_px = std::max(least_px, s.min);
    most_px = std::max(most_px, s.max);
  }
  while (most_px > least_px && needed_px2(left, most_px) > kFilledByTheRest * free_px2) most_px *= kSizeStep;
  return std::max(least_px, most_px);
}

float size_of_attempt(int attempt) {
  float size = 1;
  for (int a = 0; a < attempt; ++a) size *= kNextAttempt;
  return size;
}

double size_factor(double area_px2, double part, const std::vector<Interval>& shapes) {
  double needed = 0;
  for (const Interval& s : shapes) {
    needed += mean_square_px2(s.min, s.max) * (s.max < s.min * kNearlyOneSize ? 1 : kNearTheTop);
  }
  return needed > 0 ? std::sqrt(part * area_px2 / needed) : 1;
}

}  // namespace tessera
