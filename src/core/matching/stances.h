// Stances: the ways in which each shape may stand in the region of the canvas that is being filled. Matching makes
// poses inside them only, so that no slot is spent on what may not stand. kernels/stances.cl looks them up in the same
// way.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/matching/pose_range.h"
#include "core/settings/settings.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// One way in which a shape may stand: an interval of scales, one of rotations, and how much it is wished for.
struct Stance {
  PoseRange poses;
  /// Rotations that a docking may imply before it is turned into `poses`: a little more than are allowed.
  DirectionRange docked_rotations;
  float log2_scale_ratio = 0;  // of the largest scale to the smallest
  float weight = 1;            // of docking keys and scores
};

/// With this part (0..1) of the octaves of its sizes, from the smallest on.
Stance with_sizes_up_to(float part, Stance stance);

/// The stances of a class of shapes, which lie behind one another.
struct StanceList {
  std::uint32_t first = 0;
  std::uint32_t count = 0;  // 0: may not stand
  float min_scale_px = 0;   // of all of them
  float max_scale_px = 0;
};

/// What may stand for the moment, of all that may stand at all. It changes from round to round.
struct StandingLimits {
  std::uint32_t region = 0;  // of the canvas, that is being filled
  float size_factor = 1;     // times all sizes
  float most_scale_px = std::numeric_limits<float>::infinity();
  std::vector<ShapeId> used_up = {};  // ascending

  friend bool operator==(const StandingLimits&, const StandingLimits&) = default;
};

class StanceTable {
 public:
  /// Of the settings' wishes for a library of so many shapes.
  StanceTable(const CollageSettings& settings, std::uint32_t library_shapes);
  StanceTable() = default;

  /// The stances of the whole table that `limits` leave. A stance keeps its place.
  StanceTable limited(const StandingLimits& limits) const;

  const StanceList& list(ShapeId shape) const { return lists_[class_of(shape)]; }
  std::span<const Stance> of(const StanceList& list) const { return {stances_.data() + list.first, list.count}; }
  const Stance& operator[](std::uint32_t stance) const { return stances_[stance]; }

  std::uint32_t class_of(ShapeId shape) const { return class_of_shape_.empty() ? 0 : class_of_shape_[index_of(shape)]; }
  std::uint32_t library_shapes() const { return library_shapes_; }
  const std::vector<Stance>& stances() const { return stances_; }
  /// By class. The last class is that of shapes that may not stand.
  const std::vector<StanceList>& lists() const { return lists_; }

  /// How many shapes may stand, and the one of them at `place`, in the order of the library.
  std::uint32_t open_shapes() const { return all_open_ ? library_shapes_ : std::uint32_t(open_.size()); }
  ShapeId open_shape(std::uint32_t place) const { return ShapeId(all_open_ ? place : open_[place]); }
  /// Every shape may stand.
  bool all_open() const { return all_open_; }
  /// Some rotations are not allowed.
  bool limits_rotations() const;
  /// The smallest scale in which some shape may stand; infinite where none may.
  float least_scale_px() const;

 private:
  StanceList add_list(std::vector<Interval> scales_px, const std::vector<Interval>& rotations_rad, float weight);
  void set_scales(StanceList& list) const;
  void list_open_shapes();

  std::vector<Stance> stances_;
  std::vector<std::vector<StanceList>> lists_in_region_;  // of the whole table
  std::vector<StanceList> lists_;
  std::vector<std::uint32_t> class_of_shape_;  // empty: all of class 0
  std::uint32_t library_shapes_ = 0;
  std::vector<std::uint32_t> open_;  // ascending; empty where all are
  bool all_open_ = true;
};

/// What both allow; intervals of rotations are compared modulo a whole turn.
std::vector<Interval> common_intervals(const std::vector<Interval>& a, const std::vector<Interval>& b);
std::vector<Interval> common_rotations(const std::vector<Interval>& a, const std::vector<Interval>& b);

}  // namespace tessera
