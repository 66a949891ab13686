// Beyond greedy, which the paper names as its limit (section 6): take a few small pieces beside a gap out, fill the
// hole again, and keep the result where more of the canvas is covered.
#pragma once

#include <functional>

#include "master/collage.h"
#include "master/filling.h"

namespace tessera::master {

enum class Trial { kept, put_back, interrupted };

class RuinAndRecreate {
 public:
  RuinAndRecreate(Collage& collage, Filling& filling, const CollageSettings& settings);

  /// Trial number `trial`: its outcome follows from this number and the placements alone. `stopped` is asked before
  /// every piece; an interrupted trial, also where the matcher throws Interrupted, leaves the placements as they were.
  Trial try_once(std::uint32_t trial, const std::function<bool()>& stopped);

 private:
  std::vector<std::size_t> pieces_near(Vec2 gap_px) const;
  /// The placements without a few beside a gap; all of them where there is no gap, or no small piece.
  std::vector<Placement> ruined(std::uint64_t random);

  Collage& collage_;
  Filling& filling_;
  std::uint64_t seed_;
  float most_scale_px_;
  std::size_t most_pieces_;
};

}  // namespace tessera::master
