#include "master/rules/standing_pieces.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/collage/region_below.h"

namespace tessera::master {

GivenPieces::GivenPieces(const Canvas& canvas, const Wishes& wishes, ShapeSource& shapes)
    : locked_(wishes.locked()),
      free_in_(std::max<std::size_t>(1, canvas.regions.size())) {
  for (const GivenPiece& piece : wishes.given) {
    all_.push_back({piece.shape, canvas.period.wrapped(piece.canvas_from_shape), piece.score, piece.matched_px});
  }
  for (std::size_t i = locked_; i < all_.size(); ++i) {
    const Placement& p = all_[i];
    const bool one_region = free_in_.size() == 1;
    free_in_[one_region ? 0 : region_below(canvas, shapes.shape(p.shape).outline, p.canvas_from_shape)].push_back(p);
  }
}

/// The free pieces of the region still stand in the job's order, as nothing has moved them yet.
StandingPieces GivenPieces::when_begun(std::uint32_t region, const std::vector<Placement>& standing) const {
  auto free = free_in_[region].begin();
  std::vector<Placement> given;
  for (std::size_t i = 0; i < standing.size(); ++i) {
    if (i >= locked_ && free != free_in_[region].end() && standing[i] == *free) {
      ++free;
    } else {
      given.push_back(standing[i]);
    }
  }
  return when_begun_with(region, std::move(given));
}

StandingPieces GivenPieces::when_begun_with(std::uint32_t region, std::vector<Placement> given) const {
  const std::size_t count = given.size();
  given.insert(given.end(), free_in_[region].begin(), free_in_[region].end());
  return {std::move(given), count};
}

}  // namespace tessera::master
