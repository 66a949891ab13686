#include "core/matching/pair_limits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/pad/pad_index.h"

namespace tessera {
namespace {

constexpr std::uint32_t kFewestBins = 2;

/// The number of bins of the first count. In a larger library the wanted pairs lie nearer. The number is a third to
/// half of what most samples need with 120 and with 10,000 shapes, so that samples that need less have not searched
/// much too far.
std::uint32_t first_bins(std::uint32_t shapes, std::uint64_t pairs) {
  constexpr double kBinsOfOnePairAShape = 27;
  const double bins = kBinsOfOnePairAShape * std::cbrt((double(pairs) + 1) / (double(shapes) + 1));
  return std::uint32_t(std::clamp(bins, double(kFewestBins), kDistanceBins / 2.0));
}

/// The next number of bins, after `bins` bins held `found` pairs. The number of pairs grows about with the cube of the
/// distance; aiming at half as many again as wanted costs little.
std::uint32_t farther(std::uint32_t bins, std::uint64_t found, double wanted) {
  const double factor = std::cbrt(1.5 * (wanted + 1) / double(std::max<std::uint64_t>(found, 1)));
  const auto next = std::uint32_t(std::ceil(double(bins) * std::clamp(factor, 1.0, 2.0)));
  return std::clamp(next, std::max(kFewestBins, bins + 1), std::uint32_t(kDistanceBins));
}

/// The stride of segments that are counted for an estimate. A few segments are enough, but not so few that a sample
/// finds hardly any pair in them.
std::uint32_t stride_of_estimate(std::uint32_t shapes) {
  constexpr std::uint32_t kFewestSegments = 6;
  constexpr std::uint32_t kMostStride = 16;
  return std::clamp(shapes / (kFewestSegments * kSegmentShapes), 1u, kMostStride);
}

/// The fraction of the library's shapes that lies in every stride-th segment.
double share_of(std::uint32_t stride, std::uint32_t shapes) {
  std::uint32_t counted = 0;
  for (std::uint32_t first = 0; first < shapes; first += stride * kSegmentShapes) {
    counted += std::min(kSegmentShapes, shapes - first);
  }
  return double(counted) / double(shapes);
}

/// Counts from `bins` bins on, with more bins each time, until each sample has more than `pairs` pairs or all bins.
std::vector<DistanceHistogram> count_until_enough(std::vector<std::uint32_t> bins, std::uint64_t pairs,
                                                  std::uint32_t stride, const CountPairs& count) {
  std::vector<DistanceHistogram> found(bins.size());
  while (std::any_of(bins.begin(), bins.end(), [](std::uint32_t b) { return b > 0; })) {
    const std::vector<DistanceHistogram> counted = count(bins, stride);
    if (std::ptrdiff_t(counted.size()) !=
        std::count_if(bins.begin(), bins.end(), [](std::uint32_t b) { return b > 0; })) {
      throw std::logic_error("a matcher counted other samples than it was asked for");
    }
    auto next = counted.begin();
    for (std::size_t t = 0; t < bins.size(); ++t) {
      if (bins[t] == 0) continue;
      found[t] = *next++;
      const std::uint64_t sum = std::accumulate(found[t].begin(), found[t].end(), std::uint64_t(0));
      const bool enough = sum > pairs || bins[t] == kDistanceBins;
      bins[t] = enough ? 0 : farther(bins[t], sum, double(pairs));
    }
  }
  return found;
}

/// An estimate of the bins that each sample needs, from every stride-th segment.
std::vector<std::uint32_t> estimated_bins(std::vector<std::uint32_t> first, std::uint64_t pairs, std::uint32_t shapes,
                                          std::uint32_t stride, const CountPairs& count) {
  // The share is raised by a quarter, so that one further count is enough for most samples.
  const auto share = std::uint64_t(std::ceil(1.25 * double(pairs) * share_of(stride, shapes)));
  std::vector<std::uint32_t> bins;
  for (const DistanceHistogram& found : count_until_enough(std::move(first), share, stride, count)) {
    std::uint64_t sum = 0;
    std::uint32_t bin = 0;
    while (bin < kDistanceBins && sum <= share) sum += found[bin++];
    bins.push_back(std::max(bin, kFewestBins));
  }
  return bins;
}

}  // namespace

std::vector<std::uint32_t> pair_limits(std::size_t samples, std::uint64_t pairs, std::uint32_t shapes,
                                       const CountPairs& count) {
  std::vector<std::uint32_t> bins(samples, first_bins(shapes, pairs));
  const std::uint32_t stride = stride_of_estimate(shapes);
  if (stride > 1) bins = estimated_bins(std::move(bins), pairs, shapes, stride, count);
  std::vector<std::uint32_t> limits;
  for (const DistanceHistogram& found : count_until_enough(std::move(bins), pairs, 1, count)) {
    limits.push_back(bin_limit_for(found, pairs));
  }
  return limits;
}

std::vector<std::uint32_t> pair_limits(Matcher& matcher, const std::vector<TargetSample>& samples,
                                       std::uint64_t pairs) {
  bool sent = false;
  const ShapeRange shapes = matcher.shapes();
  return pair_limits(samples.size(), pairs, shapes.end - shapes.begin,
                     [&](const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride) {
                       matcher.post_count({sent ? std::vector<TargetSample>{} : samples, bins, segment_stride});
                       sent = true;
                       return matcher.take_count();
                     });
}

}  // namespace tessera
