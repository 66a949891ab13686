#include "master/sample_schedule.h"

#include <algorithm>

namespace tessera::master {

std::vector<TargetSample> SampleSchedule::take() {
  std::vector<TargetSample> samples;
  for (const SampleId id : stale_) {
    samples.push_back(curve_.sample(id));
    samples.back().pass = first_pass_ + matched_[id].passes++;
  }
  stale_.clear();
  return samples;
}

void SampleSchedule::put_back(const std::vector<TargetSample>& samples) {
  for (const TargetSample& sample : samples) {
    stale_.insert(sample.id);
    const auto matched = matched_.find(sample.id);
    --matched->second.passes;
    if (matched->second.passes == 0 && matched->second.searches == 0) matched_.erase(matched);
  }
}

void SampleSchedule::mark(const Window& window) {
  for (const SampleId id : curve_.samples()) {
    if (may_dock(id) && lies_in(window, id)) stale_.insert(id);
  }
}

void SampleSchedule::follow(const TargetCurve::Change& change) {
  for (const SampleId id : change.removed) {
    stale_.erase(id);
    matched_.erase(id);
    in_region_.erase(id);
    behind_.erase(id);
  }
  for (const SampleId id : change.renewed) {
    if (may_dock(id)) stale_.insert(id);
    const auto matched = matched_.find(id);
    if (matched != matched_.end()) matched->second.searches = 0;
    if (searched_ == 0 || !lies_in(region_, id)) continue;
    in_region_.insert(id);
    behind_.insert(id);
  }
}

void SampleSchedule::search_in(const Window& region) {
  region_ = region;
  forget_searches();
  for (auto& [id, matched] : matched_) matched.searches = 0;
}

int SampleSchedule::mark_for_search(int most) {
  const std::vector<SampleId> behind = least_searched();
  const std::uint32_t times = behind.empty() ? searched_ : searches(behind.front());
  if (times >= std::uint32_t(most)) return 0;
  const std::vector<SampleId> marked = behind.empty() ? all_of_region() : behind;
  if (marked.empty()) return 0;
  if (behind.empty()) ++searched_;
  for (const SampleId id : marked) {
    stale_.insert(id);
    matched_[id].searches = times + 1;
    if (times + 1 == searched_) behind_.erase(id);
  }
  return int(times + 1);
}

/// Finds the samples that were searched less often than the others, and among these the ones that were searched the fewest
/// times. Only samples count at which pieces may dock.
std::vector<SampleId> SampleSchedule::least_searched() const {
  std::vector<SampleId> least;
  for (const SampleId id : behind_) {
    if (!may_dock(id)) continue;
    if (!least.empty() && searches(id) < searches(least.front())) least.clear();
    if (least.empty() || searches(id) == searches(least.front())) least.push_back(id);
  }
  return least;
}

/// Finds all samples of the region at which pieces may dock. The other samples of the region fall behind.
std::vector<SampleId> SampleSchedule::all_of_region() {
  if (searched_ == 0) find_region();
  std::vector<SampleId> all;
  for (const SampleId id : in_region_) {
    if (may_dock(id)) {
      all.push_back(id);
    } else {
      behind_.insert(id);
    }
  }
  return all;
}

/// Looks at all samples of the curve, which takes long on large canvases.
void SampleSchedule::find_region() {
  for (const SampleId id : curve_.samples()) {
    if (lies_in(region_, id)) in_region_.insert(id);
  }
}

void SampleSchedule::forget_searches() {
  searched_ = 0;
  in_region_.clear();
  behind_.clear();
}

std::uint32_t SampleSchedule::searches(SampleId id) const {
  const auto matched = matched_.find(id);
  return matched == matched_.end() ? 0 : matched->second.searches;
}

bool SampleSchedule::lies_in(const Window& window, SampleId id) const {
  const Vec2 node = curve_.sample(id).position - free_.field().origin;
  const int x = int(node.x);
  const int y = int(node.y);
  return free_.grid().overlap(window, {x, y, x + 1, y + 1});
}

void SampleSchedule::clear() {
  stale_.clear();
  matched_.clear();
  forget_searches();
}

bool SampleSchedule::may_dock(SampleId id) const {
  return !growth_ || growth_->may_dock(free_, curve_.sample(id).position);
}

bool SampleSchedule::any_may_dock() const {
  const std::vector<SampleId> samples = curve_.samples();
  return std::any_of(samples.begin(), samples.end(), [&](SampleId id) { return may_dock(id); });
}

void SampleSchedule::save(CheckpointState& state) const {
  state.stale.assign(stale_.begin(), stale_.end());
  for (const auto& [id, matched] : matched_) state.matches.push_back({id, matched.passes, matched.searches});
  std::sort(state.matches.begin(), state.matches.end(),
            [](const SampleMatches& a, const SampleMatches& b) { return a.id < b.id; });
  state.searched = searched_;
}

void SampleSchedule::restore(const CheckpointState& state) {
  stale_ = {state.stale.begin(), state.stale.end()};
  for (const SampleMatches& sample : state.matches) matched_[sample.id] = {sample.passes, sample.searches};
  searched_ = state.searched;
  if (searched_ == 0) return;
  find_region();
  for (const SampleId id : in_region_) {
    if (searches(id) < searched_) behind_.insert(id);
  }
}

}  // namespace tessera::master
