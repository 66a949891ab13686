// The one interface of matching: target samples in, candidates out. Implemented by a plain C++ reference, by OpenCL
// devices, and by whatever joins several of them (devices of a rank, ranks of a job); one test suite holds for all.
//
// Matching is four questions. Each selects per (sample, shape) or through a threshold over the whole library, never
// per part of it, so that the answers do not depend on how the library is divided:
//   count   how many pairs (target sample, shape PAD) lie in each bin of the PAD distance, as far as is asked -> the top
//           K % threshold (pair_limits.h)
//   dock    the best dockings of each target sample, from pairs below the threshold and from tangent dockings
//   refine  given dockings moved to their best pose, with the terms of the objective and what else scoring needs
//   measure the terms of given poses, after the field has changed
//
// A question is posted, then taken: whoever joins several matchers posts to all before it takes from any. One of them
// may count some samples after others: whoever joins several has each of them take its next step as soon as it is
// ready, so that they work at the same time, however many steps each has.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/field/field_lookup.h"
#include "core/field/target_sample.h"
#include "core/geometry/extent.h"
#include "core/matching/docking.h"
#include "core/matching/docking_terms.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// The nodes of `window` of the free field, row by row.
struct FieldPatch {
  Window window;
  std::vector<float> value;
};

using DistanceHistogram = std::array<std::uint32_t, kDistanceBins>;

struct CountRequest {
  /// None: those of the question before, which was to count, too.
  std::vector<TargetSample> samples;
  /// Of each sample: its pairs in the bins below this are counted; 0 = it is left out.
  std::vector<std::uint32_t> bins;
  /// Of the library's segments (kSegmentShapes) only each one whose number is a multiple of this counts, to estimate.
  std::uint32_t segment_stride = 1;
};

struct DockRequest {
  std::vector<TargetSample> samples;
  /// Per sample: pairs whose distance bin is below this are docked; 0 = none.
  std::vector<std::uint32_t> bin_limit;
  std::uint32_t tangent_dockings = 0;
  /// Each sample keeps the dockings that were drawn first of those that the early reject leaves, instead of the best
  /// ones: by its key dockings that cross thin lines come first. Without pairs.
  bool first_drawn = false;
};

struct DockReply {
  /// At most kShortlist for each sample, by sample, then best first (docks_better).
  std::vector<Docking> dockings;
  std::uint64_t evaluated = 0;  // dockings that looked at the field
};

struct RefinedDocking {
  Docking docking;  // with the refined pose
  DockingTerms terms{};
  bool feasible = false;  // if not, nothing but the docking counts
  Extent extent{};        // of the boundary points
  float perimeter = 0;    // the shape's
  float radius = 0;

  friend bool operator==(const RefinedDocking&, const RefinedDocking&) = default;
};

/// A part of a divided library, as whoever joins the parts sees it: what only this part is asked, and all its answers.
/// What all parts are told alike is no function of a part, as it may reach all of them at once (Matcher).
class MatcherPart {
 public:
  virtual ~MatcherPart() = default;

  virtual ShapeRange shapes() const = 0;

  /// Takes the next step of the count that was posted, which waits for no more than this matcher's own devices, and
  /// tells whether there may be another one. take_count takes the steps that are left; without steps there are none.
  virtual bool step_count() { return false; }
  /// Whether the next step would not have to wait.
  virtual bool step_is_ready() { return true; }
  /// Of the samples that were not left out, in order.
  virtual std::vector<DistanceHistogram> take_count() = 0;
  virtual DockReply take_dock() = 0;
  /// Every docking's shape must be in shapes(), its stance one of the context's.
  virtual void post_refine(const std::vector<Docking>& dockings) = 0;
  /// The answers stand in the order of the dockings posted.
  virtual std::vector<RefinedDocking> take_refine() = 0;
  /// Every docking's shape must be in shapes().
  virtual void post_measure(const std::vector<Docking>& dockings) = 0;
  /// The answers stand in the order of the dockings posted.
  virtual std::vector<DockingTerms> take_measure() = 0;
};

class Matcher : public MatcherPart {
 public:
  /// Begins a new free field; its first patch covers it whole. `width`, `height`: nodes; `origin`: canvas px of node
  /// (0, 0).
  virtual void start_field(int width, int height, Vec2 origin) = 0;
  virtual void update_field(const FieldPatch& patch) = 0;
  /// What may stand in the requests that follow; without it all that the context allows.
  virtual void limit(const StandingLimits& limits) = 0;

  virtual void post_count(const CountRequest& request) = 0;
  virtual void post_dock(const DockRequest& request) = 0;
};

/// The bin of a PAD distance below beta.
inline std::uint32_t distance_bin(std::uint32_t distance_steps, std::uint32_t beta_steps) {
  return distance_steps * kDistanceBins / beta_steps;
}

/// Exactly the distances of the first `bins` bins are below this.
inline std::uint32_t reach_of_bins(std::uint32_t bins, std::uint32_t beta_steps) {
  return (bins * beta_steps + kDistanceBins - 1) / kDistanceBins;
}

/// The number of whole bins, counted from the best, that hold at most `most` pairs; at least the first one that is not
/// empty, so that no sample goes without. All of them where the histogram holds no more than `most`.
std::uint32_t bin_limit_for(const DistanceHistogram& histogram, std::uint64_t most);

/// Throws std::logic_error where a CountRequest has bins of other samples than the `counted` ones.
void expect_bins_of(std::size_t counted, const std::vector<std::uint32_t>& bins);

RefinedDocking feasible_docking(const Docking& docking, const DockingTerms& terms, const ShapeModel& shape);

/// Replaces the keys of random dockings, so that those that were drawn earlier are better.
void rank_by_draw(std::vector<Docking>& dockings);

/// Sorts (docks_better) and keeps the best kShortlist.
void keep_shortlist(std::vector<Docking>& dockings);

FieldPatch read_patch(const Grid<float>& field, const Window& window);
void write_patch(const FieldPatch& patch, Grid<float>& field);

}  // namespace tessera
