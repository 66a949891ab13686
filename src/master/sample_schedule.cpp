#include "master/sample_schedule.h"

#include <algorithm>

namespace tessera::master {

std::vector<TargetSample> SampleSchedule::take() {
  std::vector<TargetSample> samples;
  for (const SampleId id : stale_) {
    samples.push_back(curve_.sample(id));
    samples.back().pass = first_pass_ + passes_[id]++;
  }
  stale_.clear();
  return samples;
}

void SampleSchedule::put_back(const std::vector<TargetSample>& samples) {
  for (const TargetSample& sample : samples) {
    stale_.insert(sample.id);
    const auto passes = passes_.find(sample.id);
    if (--passes->second == 0) passes_.erase(passes);
  }
}

void SampleSchedule::mark(const Window& window) {
  for (const SampleId id : curve_.samples()) {
    const Vec2 node = curve_.sample(id).position - free_.field().origin;
    const int x = int(node.x);
    const int y = int(node.y);
    if (may_dock(id) && free_.grid().overlap(window, {x, y, x + 1, y + 1})) stale_.insert(id);
  }
}

void SampleSchedule::follow(const TargetCurve::Change& change) {
  for (const SampleId id : change.removed) stale_.erase(id);
  for (const SampleId id : change.renewed) {
    if (may_dock(id)) stale_.insert(id);
  }
}

void SampleSchedule::clear() {
  stale_.clear();
  passes_.clear();
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
  for (const auto& [id, passes] : passes_) state.passes.push_back({id, passes});
}

void SampleSchedule::restore(const CheckpointState& state) {
  stale_ = {state.stale.begin(), state.stale.end()};
  for (const SamplePasses& sample : state.passes) passes_[sample.id] = sample.passes;
}

}  // namespace tessera::master
