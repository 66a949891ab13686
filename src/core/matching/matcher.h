// The one interface of matching: target samples in, candidates out. Implementations are a plain C++ reference, OpenCL
// devices, and matchers that join others (devices of a rank, ranks of a job). One test suite holds for all.
//
// Matching is four questions. Each selects per (sample, shape) or by a threshold over the whole library, never per part
// of the library. So the answers do not depend on how the library is divided:
//   count   number of pairs (target sample, shape PAD) in each bin of the PAD distance, up to a limit -> the top K %
//           threshold (pair_limits.h)
//   dock    the best dockings of each target sample, from pairs below the threshold and from tangent dockings
//   refine  moves given dockings to their best pose; adds the terms of the objective and the sizes that scoring needs
//   measure the terms of given poses, after the field has changed
//
// A question is posted first and taken later, so that a joining matcher posts to all parts before it takes from any. A
// matcher may count its samples in several steps. The joining matcher lets each part take its next step as soon as that
// part is ready. So all parts work at the same time, however many steps each has.
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
  /// Empty: the samples of the question before, which must have been a count, too.
  std::vector<TargetSample> samples;
  /// Per sample: pairs in bins below this number are counted; 0 = the sample is left out.
  std::vector<std::uint32_t> bins;
  /// Only library segments (kSegmentShapes) whose number is a multiple of this stride are counted; above 1 the count is
  /// an estimate.
  std::uint32_t segment_stride = 1;
};

struct DockRequest {
  std::vector<TargetSample> samples;
  /// Per sample: pairs whose distance bin is below this number are docked; 0 = none.
  std::vector<std::uint32_t> bin_limit;
  std::uint32_t tangent_dockings = 0;
  /// If set, each sample keeps the dockings that were drawn first and passed the early reject, not the best ones. The
  /// key prefers dockings that cross thin lines. Requests with this flag have no pairs.
  bool first_drawn = false;
};

struct DockReply {
  /// At most kShortlist for each sample, by sample, then best first (docks_better).
  std::vector<Docking> dockings;
  std::uint64_t evaluated = 0;  // dockings that were tested on the field
};

struct RefinedDocking {
  Docking docking;  // with the refined pose
  DockingTerms terms{};
  bool feasible = false;  // if false, only `docking` is meaningful
  Extent extent{};        // of the boundary points
  float perimeter = 0;    // the shape's
  float radius = 0;

  friend bool operator==(const RefinedDocking&, const RefinedDocking&) = default;
};

/// A part of a divided library: the questions that only this part is asked, and all its answers. Messages that are the
/// same for all parts are functions of Matcher instead, as one message may reach all parts at once.
class MatcherPart {
 public:
  virtual ~MatcherPart() = default;

  virtual ShapeRange shapes() const = 0;

  /// Takes the next step of the count that was posted and tells whether another step may follow. The step waits for
  /// this matcher's own devices only. take_count takes the steps that are left. The default has no steps.
  virtual bool step_count() { return false; }
  /// Whether the next step can start without waiting.
  virtual bool step_is_ready() { return true; }
  /// One histogram for each sample that was not left out, in order.
  virtual std::vector<DistanceHistogram> take_count() = 0;
  virtual DockReply take_dock() = 0;
  /// Every docking's shape must be in shapes(), its stance in the context's StanceTable.
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
  /// Changes the field. Patches may overlap: a later one wins.
  virtual void update_field(const std::vector<FieldPatch>& patches) = 0;
  /// Limits the requests that follow. Before the first call all that the context allows may stand.
  virtual void limit(const StanceLimits& limits) = 0;

  virtual void post_count(const CountRequest& request) = 0;
  virtual void post_dock(const DockRequest& request) = 0;
};

/// The bin of a PAD distance below beta.
inline std::uint32_t distance_bin(std::uint32_t distance_steps, std::uint32_t beta_steps) {
  return distance_steps * kDistanceBins / beta_steps;
}

/// The distances of the first `bins` bins are exactly those below this value, steps.
inline std::uint32_t reach_of_bins(std::uint32_t bins, std::uint32_t beta_steps) {
  return (bins * beta_steps + kDistanceBins - 1) / kDistanceBins;
}

/// The number of whole bins, counted from the best, that hold at most `most` pairs. It includes the first bin that is
/// not empty, so that every sample gets pairs. All bins if the histogram holds no more than `most`.
std::uint32_t bin_limit_for(const DistanceHistogram& histogram, std::uint64_t most);

/// Throws std::logic_error if `bins` is not empty and its size differs from `counted`, the number of samples.
void expect_bins_of(std::size_t counted, const std::vector<std::uint32_t>& bins);

RefinedDocking feasible_docking(const Docking& docking, const DockingTerms& terms, const ShapeModel& shape);

/// Replaces the keys of random dockings, so that earlier draws are better.
void rank_by_draw(std::vector<Docking>& dockings);

/// Sorts by docks_better and keeps the best kShortlist.
void keep_shortlist(std::vector<Docking>& dockings);

FieldPatch read_patch(const Grid<float>& field, const Window& window);
void write_patches(const std::vector<FieldPatch>& patches, Grid<float>& field);

}  // namespace tessera
