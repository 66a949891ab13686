// Decides which target samples are matched, and with which random dockings: new samples, samples with few candidates left,
// and, where no candidate fits, samples that are searched again.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "core/collage/checkpoint_state.h"
#include "core/field/free_field.h"
#include "core/field/target_curve.h"
#include "master/rules/outward_growth.h"

namespace tessera::master {

class SampleSchedule {
 public:
  /// Schedules the samples of `curve`, which bounds `free`. With a `growth` only samples count at which pieces may dock.
  /// All arguments outlive the schedule.
  SampleSchedule(const FreeField& free, const TargetCurve& curve, const std::optional<OutwardGrowth>& growth)
      : free_(free),
        curve_(curve),
        growth_(growth) {}

  /// Gives the samples to be matched (again), ascending, and counts them as matched from now on. Each time a sample gets
  /// the random dockings of its next pass (TargetSample::pass).
  std::vector<TargetSample> take();
  /// Undoes the take() that gave these samples, because they were not matched after all.
  void put_back(const std::vector<TargetSample>& samples);

  /// Marks the sample to be matched again.
  void mark(SampleId id) { stale_.insert(id); }
  /// Marks the samples in the window and its images to be matched again.
  void mark(const Window& window);
  /// Follows a change of the curve: forgets removed samples, and marks renewed samples to be matched again.
  void follow(const TargetCurve::Change& change);

  /// Only samples in this window and its images are searched again. So far none was.
  void search_in(const Window& region);
  /// Marks samples to be matched again: those that were searched the fewest times since they were renewed. Returns how
  /// often that is, this time included, or 0 and marks none where each was searched `most` times.
  int mark_for_search(int most);
  /// Forgets everything: no sample is to be matched, and none has been matched.
  void clear();
  /// Sets the number of the pass in which a sample is matched for the first time.
  void set_first_pass(std::uint32_t pass) { first_pass_ = pass; }

  /// Whether pieces may dock at any sample.
  bool any_may_dock() const;

  void save(CheckpointState& state) const;
  /// Restores the state into a schedule that is clear.
  void restore(const CheckpointState& state);

 private:
  struct Matched {
    std::uint32_t passes = 0;    // how often the sample was matched
    std::uint32_t searches = 0;  // how often it was marked for a search since it was renewed
  };
  bool may_dock(SampleId id) const;
  bool lies_in(const Window& window, SampleId id) const;
  std::uint32_t searches(SampleId id) const;
  std::vector<SampleId> least_searched() const;
  std::vector<SampleId> all_of_region();
  void find_region();
  void forget_searches();

  const FreeField& free_;
  const TargetCurve& curve_;
  const std::optional<OutwardGrowth>& growth_;
  std::set<SampleId> stale_;  // to be matched
  std::unordered_map<SampleId, Matched> matched_;
  std::uint32_t first_pass_ = 0;
  Window region_;                 // where samples are searched
  std::uint32_t searched_ = 0;    // how often each sample of the region was searched, except those in behind_
  std::set<SampleId> in_region_;  // the samples of the region; empty before the first search
  std::set<SampleId> behind_;     // samples of the region that were searched less often than the others
};

}  // namespace tessera::master
