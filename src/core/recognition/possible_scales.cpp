#include "core/recognition/possible_scales.h"

#include <algorithm>

namespace tessera {
namespace {

/// Sizes of shapes that are searched: at least this fraction of the query's extent, at most this multiple of the length
/// of its curves.
constexpr float kLeastSize = 0.22f;
constexpr float kLargestSize = 1.2f;
/// Largest ratio of the scale by key points to the known one.
constexpr float kKnownSlack = 1.1f;
/// Largest factor by which the scale may change while a pose is refined.
constexpr float kRefinedSlack = 1.4f;
constexpr float kRefinedKnownSlack = 1.02f;

}  // namespace

PossibleScales::PossibleScales(const Query& query, const KnownShapes& shapes, std::optional<float> query_per_drawn_px)
    : shapes_(shapes),
      query_per_drawn_px_(query_per_drawn_px),
      limits_{kLeastSize * query.extent(), kLargestSize * query.length()} {
  if (!query_per_drawn_px_) return;
  limits_ = {known(0), known(0)};
  for (std::uint32_t shape = 1; shape < shapes.size(); ++shape) {
    limits_ = {std::min(limits_.least, known(shape)), std::max(limits_.most, known(shape))};
  }
  limits_ = {limits_.least / kKnownSlack, limits_.most * kKnownSlack};
}

bool PossibleScales::may_have(std::uint32_t shape, const ScaleLimits& scales) const {
  if (!query_per_drawn_px_) return true;
  return known(shape) > scales.least / kKnownSlack && known(shape) < scales.most * kKnownSlack;
}

ScaleLimits PossibleScales::near(std::uint32_t shape, const Similarity& query_from_shape) const {
  if (query_per_drawn_px_) return {known(shape) / kRefinedKnownSlack, known(shape) * kRefinedKnownSlack};
  const float scale = query_from_shape.scale();
  return {scale / kRefinedSlack, scale * kRefinedSlack};
}

}  // namespace tessera
