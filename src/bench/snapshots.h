// A collage as it stands at chosen moments of a run.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/collage/placement.h"
#include "master/checkpoint_keeper.h"

namespace tessera::bench {

struct Snapshot {
  double seconds = 0;  // since the start
  std::uint64_t trials = 0;
  std::vector<Placement> placements;
};

/// Keeps the first state after each of `marks_s` (ascending), and the last one before a mark that is not reached.
class Snapshots : public master::CheckpointKeeper {
 public:
  explicit Snapshots(std::vector<double> marks_s) : marks_s_(std::move(marks_s)) {}

  bool due() override { return taken_.size() < marks_s_.size() && watch_.seconds() >= marks_s_[taken_.size()]; }
  void keep(const CheckpointState& state) override {
    if (taken_.size() < marks_s_.size()) {
      taken_.push_back({watch_.seconds(), state.statistics.trials, state.placements});
    }
  }

  const std::vector<Snapshot>& taken() const { return taken_; }

 private:
  Stopwatch watch_;
  std::vector<double> marks_s_;
  std::vector<Snapshot> taken_;
};

}  // namespace tessera::bench
