#include "tessera/matching/pad.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/recognition/partial_pyramid.h"
#include "package/own_pad.h"
#include "package/pad_settings.h"
#include "package/prepared_curves.h"
#include "package/translated_errors.h"

namespace tessera::matching {
namespace {

/// Points of a curve for each width of the smoothing.
constexpr double kPointsOfWidth = 4;
constexpr int kLeastPoints = 48;
/// A curve of fewer widths has lost its shape.
constexpr double kShortestWidths = 6;

std::vector<Pad> pads_of_curve(const PreparedCurves& prepared, std::size_t curve, int samples, double sigma,
                               const PadParameters& parameters) {
  const tessera::Curve& given = prepared.curves[curve];
  const double length = tessera::length_of(given);
  // An open curve has a sample at both ends, where it has more than one.
  const int steps = given.closed ? samples : std::max(1, samples - 1);
  const double wanted_points = std::max<double>(kLeastPoints, length * kPointsOfWidth / sigma);
  const int stride = std::max(1, int(std::ceil(wanted_points / steps)));
  const int points = steps * stride + (given.closed ? 0 : 1);
  const tessera::Curve smooth = tessera::smoothed(resampled(given, points), float(sigma));
  std::vector<Pad> pads;
  for (const PartialPyramid& partial : partial_pyramids(smooth, float(sigma), stride, parameters)) {
    if (int(pads.size()) == samples) break;
    Pad pad = own_pad(partial, parameters.levels, prepared.own_from_prepared);
    pad.curve = curve;
    pad.along = prepared.own(length * double(pads.size()) / steps);
    pads.push_back(std::move(pad));
  }
  return pads;
}

/// The largest difference of the elements of one side. An element is 2^-i times an arclength, divided by the longest
/// arclength of that side that both PADs have.
double side_difference(const std::vector<double>& p, const std::vector<double>& q, std::size_t levels, double sign) {
  double largest = 0;
  double weight = 1;
  for (std::size_t i = 0; i + 1 < levels; ++i, weight /= 2) {
    largest = std::max(largest, std::abs(weight * (p[i] / p[levels - 1] - sign * q[i] / q[levels - 1])));
  }
  return largest;
}

}  // namespace

std::vector<Pad> pads_of(const Outline& outline, const PadSettings& settings) {
  return with_errors_translated([&] {
    const PreparedCurves prepared = prepared_curves(outline);
    double total = 0;
    for (const tessera::Curve& curve : prepared.curves) total += double(tessera::length_of(curve));
    const double sigma = prepared.prepared(smoothing_of(settings, prepared.own(total)));
    std::vector<Pad> pads;
    for (std::size_t c = 0; c < prepared.curves.size(); ++c) {
      const double length = tessera::length_of(prepared.curves[c]);
      if (length < kShortestWidths * sigma) continue;
      const int samples = std::max(1, int(std::lround(settings.samples * length / total)));
      const std::vector<Pad> more =
          pads_of_curve(prepared, c, samples, sigma, {settings.levels, float(settings.delta_tau_rad)});
      pads.insert(pads.end(), more.begin(), more.end());
    }
    return pads;
  });
}

double pad_distance(const Pad& p, const Pad& q) {
  const std::size_t left = std::min(p.left.size(), q.left.size());
  const std::size_t right = std::min(p.right.size(), q.right.size());
  if (std::min(left, right) < kLeastLevelsOfASide) return std::numeric_limits<double>::infinity();
  const double sign = p.convexity * q.convexity < 0 ? -1 : 1;
  return std::max(side_difference(p.left, q.left, left, sign), side_difference(p.right, q.right, right, sign));
}

}  // namespace tessera::matching
