#include "core/collage/missing_pieces.h"

#include <algorithm>
#include <limits>

#include "core/matching/stances.h"
#include "core/matching/use_limits.h"

namespace tessera {
namespace {

/// Per shape: whether it may stand in any region.
std::vector<bool> may_stand(const CollageSettings& settings, std::uint32_t shapes) {
  const StanceTable whole(settings, shapes);
  std::vector<bool> may(shapes, false);
  const auto regions = std::uint32_t(std::max<std::size_t>(1, settings.wishes.regions.size()));
  for (std::uint32_t region = 0; region < regions; ++region) {
    const StanceTable table = whole.limited({.region = region});
    for (std::uint32_t i = 0; i < table.open_shapes(); ++i) may[index_of(table.open_shape(i))] = true;
  }
  return may;
}

}  // namespace

std::vector<MissingPieces> missing_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings,
                                          const std::vector<Placement>& placements) {
  const UseLimits uses(settings.pieces, settings.wishes);
  if (!uses.any()) return {};
  std::vector<int> standing(drawings.size(), 0);
  for (const Placement& p : placements) ++standing[drawings[index_of(p.shape)]];
  const std::vector<bool> may = may_stand(settings, std::uint32_t(drawings.size()));
  std::vector<MissingPieces> missing;
  for (std::uint32_t i = 0; i < drawings.size(); ++i) {
    const int wanted = uses.least(ShapeId{i});
    if (drawings[i] == i && may[i] && standing[i] < wanted) missing.push_back({ShapeId{i}, wanted, standing[i]});
  }
  return missing;
}

double most_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const UseLimits uses(settings.pieces, settings.wishes);
  if (!uses.any()) return kNoLimit;
  const std::vector<bool> may = may_stand(settings, std::uint32_t(drawings.size()));
  double pieces = 0;
  for (std::uint32_t i = 0; i < drawings.size(); ++i) {
    if (!may[i] || drawings[i] != i) continue;
    const int most = uses.most(ShapeId{i});
    pieces += most > 0 ? double(most) : kNoLimit;
  }
  return pieces;
}

}  // namespace tessera
