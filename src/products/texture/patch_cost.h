// Judges how well a patch of the photo would continue a layout.
#pragma once

#include <cstddef>
#include <vector>

#include "products/texture/layout_canvas.h"

namespace tessera {

/// Not for use by several threads at once, because it keeps memory between calls.
class PatchCost {
 public:
  /// `use_cost`: how much it costs that the patch's elements were laid before. The arguments must outlive it.
  PatchCost(const PhotoCells& photo, const LayoutCanvas& canvas, double use_cost);

  /// `part`: what the canvas shows at patch.to. More is worse.
  double operator()(const Patch& patch, const CanvasPart& part);

 private:
  // The fate of an element in a patch.
  enum Fate : char {
    kUnseen,
    kOutside,  // its middle is not in the patch
    kSkipped,  // it would overlap others too much
    kStands
  };

  void find_fates(const Patch& patch, const CanvasPart& part);
  int badness(const Patch& patch, const CanvasPart& part) const;

  const PhotoCells& photo_;
  const LayoutCanvas& canvas_;
  const double use_cost_;
  std::vector<Fate> fates_;      // of all elements
  std::vector<int> overlapped_;  // of each seen element
  std::vector<std::size_t> seen_;
  int ground_ = 0;  // cells of the patch
};

}  // namespace tessera
