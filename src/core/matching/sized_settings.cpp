#include "core/matching/sized_settings.h"

#include <algorithm>
#include <map>

#include "core/matching/size_schedule.h"
#include "core/matching/stances.h"
#include "core/matching/use_limits.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

void multiply(std::vector<Interval>& scales_px, float factor) {
  for (Interval& scale_px : scales_px) {
    scale_px.min *= factor;
    scale_px.max *= factor;
  }
}

}  // namespace

CollageSettings with_sizes_times(double factor, CollageSettings settings) {
  PieceSettings& pieces = settings.pieces;
  pieces.several.scale_px = pieces.poses().scale_px;
  multiply(pieces.several.scale_px, float(factor));
  for (ShapeWish& shape : settings.wishes.classes) multiply(shape.poses.scale_px, float(factor));
  for (RegionWish& region : settings.wishes.regions) multiply(region.poses.scale_px, float(factor));
  pieces.min_scale_px *= float(factor);
  pieces.max_scale_px *= float(factor);
  return settings;
}

float least_size_factor(const PieceSettings& pieces) {
  const float factor = pieces.least_scale_px / pieces.min_scale_px;
  return pieces.fit_all && factor * float(kNearlyOneSize) < 1 ? factor : 1.f;
}

double first_size_factor(const CollageSettings& settings, std::uint32_t library_shapes, double area_px2,
                         const std::vector<std::uint32_t>& drawings) {
  const auto drawing = [&](ShapeId shape) { return drawings.empty() ? index_of(shape) : drawings[index_of(shape)]; };
  std::map<std::uint32_t, int> standing;
  for (const GivenPiece& piece : settings.wishes.given) {
    const double scale_px = piece.canvas_from_shape.scale();
    area_px2 -= scale_px * scale_px;
    ++standing[drawing(piece.shape)];
  }
  const StanceTable stances(settings, library_shapes);
  const UseLimits uses(settings.pieces, settings.wishes);
  std::vector<WantedPieces> wanted;
  for (std::uint32_t i = 0; i < stances.open_shapes(); ++i) {
    const ShapeId shape = stances.open_shape(i);
    if (drawing(shape) != index_of(shape)) continue;  // its drawing has these places
    const auto given = standing.find(index_of(shape));
    const int missing = uses.least(shape) - (given == standing.end() ? 0 : given->second);
    const StanceList& list = stances.list(shape);
    if (missing > 0) wanted.push_back({{list.min_scale_px, list.max_scale_px}, double(missing)});
  }
  const PieceSettings& pieces = settings.pieces;
  const double factor = size_factor(std::max(area_px2, 1.), kFirstFilling, wanted, double(pieces.padding_px));
  return std::max(factor, double(pieces.least_scale_px) / double(pieces.min_scale_px));
}

}  // namespace tessera
