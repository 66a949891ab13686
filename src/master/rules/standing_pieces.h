// The pieces that stand when a region of the canvas is begun, and how many of them must stay. A free piece of the job may
// move only while the region is filled in which it lies.
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
  std::size_t given = 0;  // the first `given` stay to the end of the region
};

class GivenPieces {
 public:
  GivenPieces(const Canvas& canvas, const Wishes& wishes, ShapeSource& shapes);

  /// The pieces of the first region, before anything is placed.
  StandingPieces at_first() const { return when_begun(0, all_); }
  /// The pieces of a region that is begun now. `standing`: the pieces of the collage, the locked ones first.
  StandingPieces when_begun(std::uint32_t region, const std::vector<Placement>& standing) const;
  /// The result of when_begun(), made again from the pieces that stay (`given`).
  StandingPieces when_begun_with(std::uint32_t region, std::vector<Placement> given) const;

  std::size_t size() const { return all_.size(); }
  bool any_free() const { return locked_ < all_.size(); }

 private:
  std::vector<Placement> all_;
  std::size_t locked_;
  std::vector<std::vector<Placement>> free_in_;  // by region
};

}  // namespace tessera::master
