// What stands when a region of the canvas is begun, and which of it improving may move there. Of the pieces that a job
// gives and that are free each may move while the region is filled in which it lies; in all others it stands still.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/settings/wishes.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

struct StandingPieces {
  std::vector<Placement> pieces;
  std::size_t given = 0;  // so many of them, the first ones, stand to the end of the region
};

class GivenPieces {
 public:
  GivenPieces(const Canvas& canvas, const Wishes& wishes, ShapeSource& shapes);

  /// When nothing is placed yet.
  StandingPieces at_first() const { return when_begun(0, all_); }
  /// `standing`: what stands when the region is begun, the locked pieces first.
  StandingPieces when_begun(std::uint32_t region, const std::vector<Placement>& standing) const;
  /// As when_begun() had it, of which `given` are known.
  StandingPieces when_begun_with(std::uint32_t region, std::vector<Placement> given) const;

  std::size_t size() const { return all_.size(); }
  bool any_free() const { return locked_ < all_.size(); }

 private:
  std::vector<Placement> all_;
  std::size_t locked_;
  std::vector<std::vector<Placement>> free_in_;  // by region
};

}  // namespace tessera::master
