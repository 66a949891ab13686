#include "core/replacing/repetition_costs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tessera {
namespace {

/// RepetitionCosts::area per repetition_exponent. At the exponent's default, 0.3, more shapes share the area than by
/// ruin and recreate alone.
constexpr double kRepetition = 0.1;
/// RepetitionCosts::nearness per repetition_exponent. At its default hardly any two large copies lie within three of
/// their sizes.
constexpr double kNearness = 1;
/// Largest reach, in sizes of the copies: the eye does not connect copies that are farther apart.
constexpr float kMostNearSizes = 5;

}  // namespace

std::size_t count_drawings(const StanceTable& stances, const ShapeSource& shapes) {
  std::vector<ShapeId> drawings;
  for (std::uint32_t i = 0; i < stances.open_shapes(); ++i)
    drawings.push_back(shapes.silhouette(stances.open_shape(i)));
  std::sort(drawings.begin(), drawings.end());
  return std::size_t(std::unique(drawings.begin(), drawings.end()) - drawings.begin());
}

RepetitionCosts repetition_costs(const CollageSettings& settings, std::size_t drawings, double area_px2) {
  const PieceSettings& pieces = settings.pieces;
  const double middle_px2 = double(pieces.min_scale_px) * double(pieces.max_scale_px);
  const double exponent = double(settings.objective.repetition_exponent);
  RepetitionCosts costs;
  costs.area = kRepetition * exponent;
  costs.even_share_px2 = std::max(middle_px2, drawings > 0 ? area_px2 / double(drawings) : 0);
  costs.nearness = kNearness * exponent;
  costs.reach_sizes = std::min(kMostNearSizes, 0.5f * std::sqrt(float(drawings)));
  return costs;
}

}  // namespace tessera
