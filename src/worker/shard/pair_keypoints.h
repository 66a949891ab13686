// The key points of the PADs that are docked: of a shard's PADs they take most of all its bytes, and few are docked.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/matching/model_source.h"
#include "records.h"

namespace tessera::worker {

class PairKeypoints {
 public:
  /// `reads`: they are read for the pairs that are asked for, else all come by add().
  PairKeypoints(const MatchRecord& match, int pad_levels, const ModelSource& models, bool reads);

  /// The key points of the shard's next shapes.
  void add(const std::vector<ShapeModel>& models);

  /// Of each pair x of its 2 n + 1 points, then y, in steps of the shape's keypoint_step.
  std::vector<std::int16_t> of(std::span<const PairRecord> pairs) const;

 private:
  std::vector<std::int16_t> read(std::span<const PairRecord> pairs) const;

  MatchRecord match_;
  int pad_levels_;
  const ModelSource* models_;
  bool reads_;
  std::vector<std::int16_t> all_;  // by source of the shard
};

}  // namespace tessera::worker
