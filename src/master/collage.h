// The collage as the master holds it: free region, target curve, pool, placements (paper section 4, Fig. 15).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/checkpoint_state.h"
#include "core/collage/placed_outlines.h"
#include "core/collage/placement.h"
#include "core/collage/pool.h"
#include "core/collage/wide_gap.h"
#include "core/field/canvas.h"
#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/matching/match_round.h"
#include "core/matching/matching_context.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"
#include "master/exact_checks.h"
#include "master/rules/kept_apart.h"
#include "master/rules/open_shapes.h"
#include "master/rules/outward_growth.h"
#include "master/rules/scoring.h"
#include "master/sample_schedule.h"
#include "master/settling.h"

namespace tessera::master {

class Collage {
 public:
  /// `context`: at size factor 1. `settings` have their sizes times `size_factor`.
  Collage(const Canvas& canvas, const CollageSettings& settings, const MatchingContext& context, ShapeSource& shapes,
          float size_factor = 1);
  Collage(const Collage&) = delete;  // its parts refer to each other
  Collage& operator=(const Collage&) = delete;

  /// From begin() on pieces dock where this says.
  void grow_by(OutwardGrowth growth) { growth_ = std::move(growth); }
  /// Begins with these pieces, of which the first `given` stand to the end, in this region of the canvas.
  void begin(std::vector<Placement> standing, std::size_t given, std::uint32_t region);

  /// Which shapes may come in for the moment; it follows from the placements.
  const OpenShapes& open_shapes() const { return open_shapes_; }
  /// Which target samples are to be matched.
  SampleSchedule& schedule() { return schedule_; }

  /// The nodes of the free field that changed since the last call; all of them at first. On a seamless canvas this
  /// window, like all those below, stands for all of its images (PeriodicGrid).
  Window take_changed_nodes();

  /// What was found for these samples enters the pool, as far as it may stand.
  void add_candidates(const std::vector<TargetSample>& samples, const MatchRound& round);

  /// Checks those candidates exactly that would be finalists now, while the workers match. Never changes what choose()
  /// finds, only how long that takes.
  void check_ahead();

  /// Whether a gap round these nodes is as wide as some shape that encloses much, and may stand, with all that it encloses.
  bool leaves_wide_gap(const Window& window);
  /// Finds a piece for such a gap by going through its nodes and rotations, where dockings find none; its size is the
  /// smallest, and what it grows. False where it finds none.
  bool choose_in_gap(Candidate& best, const Window& window, const StopCheck& check_stop);

  /// Finds the candidate of the pool that is worth most after the finalists were checked exactly, made clear of their
  /// neighbours and grown. False where the pool is dry. `check_stop` is called again and again and may throw: what has
  /// changed then would have changed anyway, and the next call finds what this one would have found.
  bool choose(Candidate& best, const StopCheck& check_stop = never_stop);

  /// Merge: takes the piece out of the free region and brings the target curve up to date. Returns the nodes within
  /// which candidates have to be measured anew.
  Window place(const Candidate& candidate);
  /// The candidates whose windows overlap `changed`.
  std::vector<Docking> touched_by(const Window& changed) const;
  /// The terms of such candidates by the master's own computation, for where the matcher does not answer any more. It
  /// agrees with the matcher's to the bit.
  std::vector<DockingTerms> measure(const std::vector<Docking>& dockings);
  /// Gives those candidates the terms that they have now, in the order of touched_by(changed).
  void rescore(const Window& changed, const std::vector<DockingTerms>& terms);

  /// Makes the collage one of `placements`: of the present ones some may be missing, others be new. Pool and stale
  /// samples are forgotten but for what the change renewed: what comes next follows from the placements before and
  /// after, not from how they came about. Returns where pieces came or went.
  Window replace_placements(std::vector<Placement> placements);

  /// Adds all that the collage keeps beside settings, canvas and library.
  void save(CheckpointState& state) const;
  /// Restores the state into a collage without placements. Throws InputError where the state does not belong to canvas
  /// and library, or where what is rebuilt from it is not what was saved.
  void restore(const CheckpointState& state);

  /// The distance from the piece to the point, or to its image that is nearest to the piece's centre, px, negative
  /// inside.
  float distance_px(const Placement& placement, Vec2 point_px);

  const FreeField& free() const { return free_; }
  const std::vector<Placement>& placements() const { return placements_; }
  double covered_px2() const { return covered_px2_; }
  std::size_t open_samples() const { return curve_.sample_count(); }

 private:
  /// A copy of a candidate, which the pool does not know as it is here.
  struct Finalist {
    Pool::Ranked ranked;
    Candidate candidate;
    bool given_up = false;
  };

  std::vector<Pool::Ranked> finalists();
  std::vector<Finalist> checked_finalists(const StopCheck& check_stop);
  bool settle_best(std::vector<Finalist>& finalists, Candidate& best, const StopCheck& check_stop);
  void keep_checks(std::vector<Finalist>& finalists);
  const HullRoom& room_of(ShapeId shape);
  std::vector<ShapeId> shapes_for_gap(float gap_px);
  std::vector<ShapeId> shapes_for_gap_in(const Window& window);
  bool needs_first_piece() const;
  bool choose_first(Candidate& first, const StopCheck& check_stop);
  const MatchingContext& context() const { return open_shapes_.context(); }
  float score(const Candidate& candidate) const;
  ExactAreas check_exactly(Candidate& candidate);
  enum class Settled { unfit, touches_little, fit };
  Settled settle(Candidate& candidate);
  Window stamp_window(const Placement& placement);
  Window restamp(const std::vector<Placement>& changed);
  void update_open_shapes();
  bool keeps_apart(const Candidate& candidate);
  std::vector<ShapeId> shut_out_shapes() const;
  void drop_what_is_too_near_to(const Placement& placement);
  std::vector<SampleId> pooled_near(const Window& changed) const;
  template <class Keep>
  void review(SampleId id, Keep keep);
  void retrace(const Window& changed);
  std::uint64_t rebuilt_digest() const;

  CollageSettings settings_;
  ShapeSource& shapes_;
  FreeField free_;
  OpenedField opened_;
  TargetCurve curve_;
  Pool pool_;
  ExactChecks checks_;
  std::vector<Placement> placements_;
  PlacedOutlines outlines_;            // of the placements
  std::map<ShapeId, HullRoom> rooms_;  // of shapes that were looked at
  Scoring scoring_;
  OpenShapes open_shapes_;
  KeptApart apart_;
  Settling settling_;
  std::optional<OutwardGrowth> growth_;
  SampleSchedule schedule_;
  double covered_px2_ = 0;
  Window changed_nodes_;
};

}  // namespace tessera::master
