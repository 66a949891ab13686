// The collage as the master holds it: free region, target curve, pool, placements (paper section 4, Fig. 15).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
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
#include "master/choosing/piece_checks.h"
#include "master/choosing/settling.h"
#include "master/rules/batch.h"
#include "master/rules/kept_apart.h"
#include "master/rules/open_shapes.h"
#include "master/rules/outward_growth.h"
#include "master/rules/scoring.h"
#include "master/sample_schedule.h"

namespace tessera::master {

class Collage {
 public:
  /// `context`: at size factor 1. The sizes in `settings` are already multiplied by `size_factor`.
  Collage(const Canvas& canvas, const CollageSettings& settings, const MatchingContext& context, ShapeSource& shapes,
          float size_factor = 1);
  Collage(const Collage&) = delete;  // its parts refer to each other
  Collage& operator=(const Collage&) = delete;

  /// Makes pieces dock as `growth` says. To be called before begin().
  void grow_by(OutwardGrowth growth) { growth_ = std::move(growth); }
  /// Begins the region number `region` of the canvas with these pieces. The first `given` of them stay to the end.
  void begin(std::vector<Placement> standing, std::size_t given, std::uint32_t region);

  /// The shapes that may be placed at the moment; they follow from the placements.
  const OpenShapes& open_shapes() const { return open_shapes_; }
  /// The target samples that are to be matched.
  SampleSchedule& schedule() { return schedule_; }

  /// The windows of the free field that changed since the last call; at first this is the whole field. On a seamless canvas
  /// a window, here and below, stands for all of its images (PeriodicGrid).
  std::vector<Window> take_changed_nodes();

  /// Puts the candidates that were found for these samples into the pool, as far as they may stand.
  void add_candidates(const std::vector<TargetSample>& samples, const MatchRound& round);

  /// Checks the candidates that the next choices will probably ask for, on all cores of the rank. It changes how long
  /// choose() takes, never what choose() finds.
  void check_ahead();

  /// Whether a gap at these nodes is wide enough for some shape that hardly docks (HullRoom) and may stand, with all that
  /// the shape encloses.
  bool leaves_wide_gap(const Window& window);
  /// Looks for a piece for such a gap where docking finds none: it tries nodes and rotations, at the smallest size, and
  /// lets the piece grow. False where it finds none.
  bool choose_in_gap(Candidate& best, const Window& window, const StopCheck& check_stop);

  /// Finds the best candidate of the pool, after it has checked the finalists exactly, moved them clear of their neighbours
  /// and grown them. Where a batch is open, only candidates count that may join it. False where no candidate of the pool
  /// fits. It calls `check_stop` often, which may throw: the pool is then in a state from which the next call finds the same
  /// candidate.
  bool choose(Candidate& best, const StopCheck& check_stop = never_stop);

  /// Places the candidate: takes it out of the free region. The piece joins the open batch, or opens one.
  void place(const Candidate& candidate);
  /// Whether pieces were placed since end_batch().
  bool batch_is_open() const { return batch_.is_open(); }

  // The end of a batch, in three steps:

  /// Brings the target curve up to date with the pieces of the batch. The samples that this renewed are to be matched.
  void merge_batch();
  /// The candidates that the pieces of the batch touch.
  std::vector<Docking> touched() const;
  /// Gives the candidates of touched() their new terms, which come in the same order.
  void end_batch(const std::vector<DockingTerms>& terms);

  /// The terms of these candidates, computed by the master where the matcher no longer answers. They agree with the
  /// matcher's to the bit.
  std::vector<DockingTerms> measure(const std::vector<Docking>& dockings);

  /// Makes the collage one of `placements`, which may lack some of the present pieces and hold new ones. Forgets the pool
  /// and the samples that wait for matching, but for samples that the change renewed: so what comes next follows from the
  /// placements before and after alone. Returns the window in which pieces came or went.
  Window replace_placements(std::vector<Placement> placements);

  /// Adds the collage's state, but for settings, canvas and library.
  void save(CheckpointState& state) const;
  /// Restores the state into a collage without placements. Throws InputError where the state does not belong to canvas
  /// and library, or where the parts rebuilt from it differ from the saved ones.
  void restore(const CheckpointState& state);

  /// The distance from the piece to the point, px, negative inside. On a seamless canvas it takes the point's image that is
  /// nearest to the piece's centre.
  float distance_px(const Placement& placement, Vec2 point_px);

  const FreeField& free() const { return free_; }
  const std::vector<Placement>& placements() const { return placements_; }
  double covered_px2() const { return covered_px2_; }
  std::size_t open_samples() const { return curve_.sample_count(); }

 private:
  /// A copy of a pooled candidate; what is found out about it reaches the pool by keep_checks().
  struct Finalist {
    Pool::Ranked ranked;
    Candidate candidate;
    bool given_up = false;
    bool waits = false;  // for the end of the batch
  };

  bool repeats(const Candidate& candidate, std::span<const Candidate* const> others) const;
  std::vector<Pool::Ranked> finalists();
  std::vector<Candidate> likely_finalists();
  std::vector<Candidate> likely_pieces(const std::vector<Candidate>& finalists) const;
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
  float worth(const Candidate& candidate) const { return candidate.score * scoring_.preference(candidate); }
  void score_exactly(Candidate& candidate, const ExactAreas& areas) const;
  enum class Settled { unfit, touches_too_little, fit };
  Settled settle(Candidate& candidate);
  Window stamp_window(const Placement& placement);
  Window touched_window(const Shape& shape, const Similarity& canvas_from_shape) const;
  void note_changed(const Window& nodes);
  void add_to_batch(const Placement& piece, float worth);
  Window restamp(const std::vector<Placement>& changed);
  void update_open_shapes();
  bool keeps_apart(const Candidate& candidate);
  std::vector<ShapeId> shut_out_shapes() const;
  void drop_candidates_near(const Placement& placement);
  std::vector<SampleId> pooled_near(const std::vector<Window>& windows) const;
  template <class Keep>
  void review(SampleId id, Keep keep);
  void retrace(const std::vector<Window>& changed);
  std::uint64_t rebuilt_digest() const;

  CollageSettings settings_;
  ShapeSource& shapes_;
  FreeField free_;
  OpenedField opened_;
  TargetCurve curve_;
  Pool pool_;
  std::vector<Placement> placements_;
  PlacedOutlines outlines_;            // of the placements
  std::map<ShapeId, HullRoom> rooms_;  // only of shapes that were asked for
  Scoring scoring_;
  OpenShapes open_shapes_;
  KeptApart apart_;
  Settling settling_;
  PieceChecks checks_;
  std::optional<OutwardGrowth> growth_;
  SampleSchedule schedule_;
  Batch batch_;
  double covered_px2_ = 0;
  std::vector<Window> changed_nodes_;
};

}  // namespace tessera::master
