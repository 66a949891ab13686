// Stances: the ways in which each shape may stand in the region of the canvas that is being filled. Matching makes only
// poses inside them, so that no slot is spent on poses that are not allowed. kernels/stances.cl looks them up in the
// same way.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/matching/pose_range.h"
#include "core/settings/settings.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// One way in which a shape may stand: an interval of scales, an interval of rotations, and a weight.
struct Stance {
  PoseRange poses;
  /// Rotations that a docking may imply before it is turned into `poses`: a little more than the allowed ones.
  DirectionRange docked_rotations;
  float log2_scale_ratio = 0;  // log2 of the largest scale over the smallest
  float weight = 1;            // factor of docking keys and scores
};

/// The stance limited to the lower fraction `part` (0..1) of the octaves of its sizes.
Stance with_sizes_up_to(float part, Stance stance);

/// The stances of a class of shapes: a range of StanceTable::stances().
struct StanceList {
  std::uint32_t first = 0;
  std::uint32_t count = 0;  // 0: these shapes may not stand
  float min_scale_px = 0;   // of all stances of the list
  float max_scale_px = 0;
};

/// Limits of the moment: the part of all stances that may be used now. They change from round to round.
struct StanceLimits {
  std::uint32_t region = 0;  // of the canvas, being filled
  float size_factor = 1;     // times all sizes
  float most_scale_px = std::numeric_limits<float>::infinity();
  std::vector<ShapeId> used_up = {};  // ascending

  friend bool operator==(const StanceLimits&, const StanceLimits&) = default;
};

class StanceTable {
 public:
  /// Makes the table of the settings' wishes for a library of `library_shapes` shapes.
  StanceTable(const CollageSettings& settings, std::uint32_t library_shapes);
  StanceTable() = default;

  /// The table with the stances of the whole table that `limits` allow. Each stance keeps its index.
  StanceTable limited(const StanceLimits& limits) const;

  const StanceList& list(ShapeId shape) const { return lists_[class_of(shape)]; }
  std::span<const Stance> of(const StanceList& list) const { return {stances_.data() + list.first, list.count}; }
  const Stance& operator[](std::uint32_t stance) const { return stances_[stance]; }

  std::uint32_t class_of(ShapeId shape) const { return class_of_shape_.empty() ? 0 : class_of_shape_[index_of(shape)]; }
  std::uint32_t library_shapes() const { return library_shapes_; }
  const std::vector<Stance>& stances() const { return stances_; }
  /// Lists by class. The last class is that of shapes that may not stand.
  const std::vector<StanceList>& lists() const { return lists_; }

  /// The number of shapes that may stand, and the one at `place` among them, in the order of the library.
  std::uint32_t open_shapes() const { return all_open_ ? library_shapes_ : std::uint32_t(open_.size()); }
  ShapeId open_shape(std::uint32_t place) const { return ShapeId(all_open_ ? place : open_[place]); }
  /// Whether every shape may stand.
  bool all_open() const { return all_open_; }
  /// Whether some rotations are not allowed.
  bool limits_rotations() const;
  /// The smallest scale at which some shape may stand; infinite if none may.
  float least_scale_px() const;

 private:
  StanceList add_list(std::vector<Interval> scales_px, const std::vector<Interval>& rotations_rad, float weight);
  void set_scales(StanceList& list) const;
  void list_open_shapes();

  std::vector<Stance> stances_;
  std::vector<std::vector<StanceList>> lists_in_region_;  // of the whole table, unlimited
  std::vector<StanceList> lists_;
  std::vector<std::uint32_t> class_of_shape_;  // empty: all shapes are of class 0
  std::uint32_t library_shapes_ = 0;
  std::vector<std::uint32_t> open_;  // ascending; empty if all are open
  bool all_open_ = true;
};

/// Intersections of two lists of intervals; rotations are compared modulo a whole turn.
std::vector<Interval> common_intervals(const std::vector<Interval>& a, const std::vector<Interval>& b);
std::vector<Interval> common_rotations(const std::vector<Interval>& a, const std::vector<Interval>& b);

}  // namespace tessera
