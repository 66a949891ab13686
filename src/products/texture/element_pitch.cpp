#include "products/texture/element_pitch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tessera {
namespace {

/// Pitches that are possible, in sides of a mean element.
constexpr double kLeast_elements = 0.4, kMost_elements = 2.5;
/// The least correlation of a photo with itself, moved by the pitch.
constexpr double kLeastCorrelation = 0.45;
/// How far from a multiple of the pitch a better one may lie, in pitches.
constexpr double kReach = 0.25;

/// How alike the profile is to itself, moved: 1 = equal, 0 = not alike.
double correlation(const std::vector<double>& profile, std::size_t moved) {
  double product = 0, first = 0, second = 0;
  for (std::size_t i = 0; i + moved < profile.size(); ++i) {
    product += profile[i] * profile[i + moved];
    first += profile[i] * profile[i];
    second += profile[i + moved] * profile[i + moved];
  }
  return first > 0 && second > 0 ? product / std::sqrt(first * second) : 0;
}

/// The lag near `around` at which the profile is most alike to itself.
std::size_t best_near(const std::vector<double>& profile, double around, double reach) {
  const auto first = std::size_t(std::max(1., around - reach)), last = std::size_t(around + reach);
  std::size_t best = first;
  for (std::size_t lag = first; lag <= last && lag < profile.size(); ++lag) {
    if (correlation(profile, lag) > correlation(profile, best)) best = lag;
  }
  return best;
}

double pitch_of(std::vector<double> profile, double element_px) {
  double mean = 0;
  for (const double value : profile) mean += value / double(profile.size());
  for (double& value : profile) value -= mean;
  // The first peak that is high: later ones are multiples of it.
  const auto least = std::size_t(std::max(2., kLeast_elements * element_px));
  const auto most = std::min(std::size_t(kMost_elements * element_px), profile.size() / 2);
  std::size_t pitch = 0;
  for (std::size_t lag = least; lag <= most && pitch == 0; ++lag) {
    const double here = correlation(profile, lag);
    if (here >= kLeastCorrelation && here >= correlation(profile, lag - 1) && here > correlation(profile, lag + 1))
      pitch = lag;
  }
  if (pitch == 0) return 0;
  // Several pitches are measured more exactly than one, as long as they agree with it.
  double exact = double(pitch);
  for (std::size_t count = 2; double(count + 1) * exact < 0.8 * double(profile.size()); ++count) {
    const double next = double(best_near(profile, double(count) * exact, kReach * exact)) / double(count);
    if (std::abs(next - double(pitch)) > kReach * double(pitch)) break;
    exact = next;
  }
  return exact;
}

}  // namespace

cv::Size2d element_pitch_px(const LabelRuns& labels, double element_px) {
  const cv::Mat mask = labels.mask();
  std::vector<double> columns(std::size_t(mask.cols)), rows(std::size_t(mask.rows));
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const double is_element = mask.at<std::uint8_t>(y, x) ? 1 : 0;
      columns[std::size_t(x)] += is_element;
      rows[std::size_t(y)] += is_element;
    }
  }
  return {pitch_of(std::move(columns), element_px), pitch_of(std::move(rows), element_px)};
}

}  // namespace tessera
