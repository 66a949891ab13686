// Beyond greedy, which the paper names as its limit (section 6): take a few small pieces beside a gap out, fill the hole
// again, and keep the result where more of the canvas is covered.
#pragma once

#include "master/collage.h"
#include "master/filling.h"

namespace tessera::master {

class RuinAndRecreate {
 public:
  RuinAndRecreate(Collage& collage, Filling& filling, const CollageSettings& settings);

  /// Trial number `trial`: its outcome follows from this number and the placements alone. True where it was kept.
  bool try_once(std::uint32_t trial);

 private:
  /// The placements without a few beside a gap.
  std::vector<Placement> ruined(std::uint64_t random);

  Collage& collage_;
  Filling& filling_;
  std::uint64_t seed_;
  float most_scale_px_;
  double free_px2_;  // of the collage as it is
};

}  // namespace tessera::master
