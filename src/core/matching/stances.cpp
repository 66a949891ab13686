#include "core/matching/stances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

constexpr float kTurn_rad = float(2 * std::numbers::pi);

Stance make_stance(const Interval& scale_px, const Interval& rotation_rad, float weight) {
  Stance s;
  s.poses = {scale_px.min, scale_px.max, direction_range(rotation_rad.min, rotation_rad.max)};
  s.docked_rotations = direction_range(rotation_rad.min - kDockingTurn_rad, rotation_rad.max + kDockingTurn_rad);
  s.log2_scale_ratio = std::log2(scale_px.max / scale_px.min);
  s.weight = weight;
  return s;
}

void add_common(const Interval& a, const Interval& b, float shift, std::vector<Interval>& common) {
  const Interval both{std::max(a.min, b.min + shift), std::min(a.max, b.max + shift)};
  if (both.min <= both.max) common.push_back(both);
}

/// The most specific wish counts: the region's or the shape's before the job's. If both the shape and the region have a
/// wish, both hold.
template <class Common>
std::vector<Interval> wished(const std::vector<Interval>& job, const std::vector<Interval>& shape,
                             const std::vector<Interval>& region, Common common) {
  if (shape.empty()) return region.empty() ? job : region;
  return region.empty() ? shape : common(shape, region);
}

}  // namespace

Stance with_sizes_up_to(float part, Stance stance) {
  if (part >= 1) return stance;
  stance.log2_scale_ratio = part * stance.log2_scale_ratio;
  stance.poses.max_scale_px = stance.poses.min_scale_px * portable_exp2(stance.log2_scale_ratio);
  return stance;
}

std::vector<Interval> common_intervals(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> common;
  for (const Interval& x : a) {
    for (const Interval& y : b) add_common(x, y, 0, common);
  }
  return common;
}

std::vector<Interval> common_rotations(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> common;
  for (const Interval& x : a) {
    if (x.max - x.min >= kTurn_rad) {  // shifted copies would overlap
      common.insert(common.end(), b.begin(), b.end());
      continue;
    }
    for (const Interval& y : b) {
      if (y.max - y.min >= kTurn_rad) {
        common.push_back(x);
        continue;
      }
      for (int turns = -2; turns <= 2; ++turns) add_common(x, y, float(turns) * kTurn_rad, common);
    }
  }
  return common;
}

StanceTable::StanceTable(const CollageSettings& settings, std::uint32_t library_shapes)
    : class_of_shape_(settings.wishes.class_of_shape),
      library_shapes_(library_shapes) {
  const PoseWish job = settings.pieces.poses();
  std::vector<ShapeWish> classes = settings.wishes.classes;
  if (classes.empty()) classes.emplace_back();
  std::vector<RegionWish> regions = settings.wishes.regions;
  if (regions.empty()) regions.emplace_back();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const PoseWish& region = regions[r].poses;
    std::vector<StanceList>& lists = lists_in_region_.emplace_back();
    for (const ShapeWish& shape : classes) {
      const bool may_stand = shape.weight > 0 && (shape.in_region.empty() || shape.in_region[r] != 0);
      const auto scales_px = wished(job.scale_px, shape.poses.scale_px, region.scale_px, common_intervals);
      const auto rotations_rad =
          wished(job.rotation_rad, shape.poses.rotation_rad, region.rotation_rad, common_rotations);
      lists.push_back(add_list(may_stand ? scales_px : std::vector<Interval>{}, rotations_rad, shape.weight));
    }
    lists.emplace_back();  // of shapes that may not stand
  }
  *this = limited({});
}

/// Adds the stances of one class, small scales first, so that a limit of the scale leaves the beginning of the list.
StanceList StanceTable::add_list(std::vector<Interval> scales_px, const std::vector<Interval>& rotations_rad,
                                 float weight) {
  std::sort(scales_px.begin(), scales_px.end(), [](const Interval& a, const Interval& b) { return a.min < b.min; });
  StanceList list;
  list.first = std::uint32_t(stances_.size());
  for (const Interval& scale_px : scales_px) {
    for (const Interval& rotation_rad : rotations_rad) stances_.push_back(make_stance(scale_px, rotation_rad, weight));
  }
  list.count = std::uint32_t(stances_.size()) - list.first;
  return list;
}

void StanceTable::set_scales(StanceList& list) const {
  list.min_scale_px = list.count > 0 ? stances_[list.first].poses.min_scale_px : 0;
  list.max_scale_px = 0;
  for (const Stance& s : of(list)) list.max_scale_px = std::max(list.max_scale_px, s.poses.max_scale_px);
}

StanceTable StanceTable::limited(const StanceLimits& limits) const {
  StanceTable table = *this;
  for (Stance& s : table.stances_) {
    s.poses.min_scale_px *= limits.size_factor;
    s.poses.max_scale_px *= limits.size_factor;
    if (s.poses.max_scale_px <= limits.most_scale_px) continue;
    s.poses.max_scale_px = std::max(s.poses.min_scale_px, limits.most_scale_px);
    s.log2_scale_ratio = std::log2(s.poses.max_scale_px / s.poses.min_scale_px);
  }
  table.lists_ = lists_in_region_[limits.region];
  for (StanceList& list : table.lists_) {
    const auto too_large = [&](const Stance& s) { return s.poses.min_scale_px > limits.most_scale_px; };
    const std::span<const Stance> all = table.of(list);
    list.count = std::uint32_t(std::find_if(all.begin(), all.end(), too_large) - all.begin());
    table.set_scales(list);
  }
  if (!limits.used_up.empty()) {
    if (table.class_of_shape_.empty()) table.class_of_shape_.assign(library_shapes_, 0);
    const std::uint32_t nowhere = std::uint32_t(table.lists_.size()) - 1;
    for (const ShapeId shape : limits.used_up) table.class_of_shape_[index_of(shape)] = nowhere;
  }
  table.list_open_shapes();
  return table;
}

bool StanceTable::limits_rotations() const {
  return std::any_of(stances_.begin(), stances_.end(), [](const Stance& s) { return !s.docked_rotations.all(); });
}

float StanceTable::least_scale_px() const {
  float least_px = std::numeric_limits<float>::infinity();
  for (const StanceList& list : lists_) {
    if (list.count > 0) least_px = std::min(least_px, list.min_scale_px);
  }
  return least_px;
}

void StanceTable::list_open_shapes() {
  open_.clear();
  for (std::uint32_t shape = 0; shape < library_shapes_; ++shape) {
    if (list(ShapeId(shape)).count > 0) open_.push_back(shape);
  }
  all_open_ = open_.size() == library_shapes_;
  if (all_open_) open_.clear();
}

}  // namespace tessera
