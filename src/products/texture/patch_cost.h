// Judges how well a patch of the photo would continue a layout.
#pragma once

#include <cstddef>
#include <vector>

#include "products/texture/counted_part.h"
#include "products/texture/layout_canvas.h"

namespace tessera {

/// Not for use by several threads at once, because it keeps memory between calls.
class PatchCost {
 public:
  /// `use_cost`: how much it costs that the patch's elements were laid before. The arguments must outlive it.
  PatchCost(const PhotoCells& photo, const LayoutCanvas& canvas, double use_cost);

  /// `part`: what the canvas shows at patch.to. More is worse: kElementCell for each cell that would be a hole, all
  /// overlaps, copies that lie near, and ground that is barer than the photo's.
  double operator()(const Patch& patch, const CountedPart& part);

 private:
  void count(const Patch& patch, const CountedPart& part);

  const PhotoCells& photo_;
  const LayoutCanvas& canvas_;
  const double use_cost_;
  std::vector<CellCounts> under_;  // of all slots, see CellRun: the cells of the canvas under what the patch shows
  std::vector<char> is_seen_;      // whether the patch shows a thing
  std::vector<int> seen_;          // the things that it shows
};

}  // namespace tessera
