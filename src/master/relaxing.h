// All pieces that stand move, turn and grow together into the gaps between them (core/relax), and come to lie where
// pieces may stand.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/field/free_field.h"
#include "core/matching/pose_range.h"
#include "core/relax/relaxation.h"
#include "core/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

class Relaxing {
 public:
  using PosesOf = std::function<PoseRange(const Placement&)>;

  /// `region`: that of the canvas which is filled, `free` its field. `poses_of`: what the pose of a piece may be. All
  /// but the settings outlive it.
  Relaxing(const Canvas& region, const FreeField& free, const PieceSettings& pieces, ShapeSource& shapes,
           PosesOf poses_of);

  /// `placements` after all but the first `given` have moved, without those that found no place. What `look` throws
  /// leaves nothing changed.
  std::vector<Placement> relaxed(const std::vector<Placement>& placements, std::size_t given,
                                 const std::function<void()>& look);

 private:
  const Canvas& region_;
  const FreeField& free_;
  PieceSettings pieces_;
  ShapeSource& shapes_;
  PosesOf poses_of_;
  Relaxation relaxation_;
};

}  // namespace tessera::master
