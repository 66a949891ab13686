// Gives the key points of the PADs that are docked. They are most of the bytes of a shard's PADs, and few PADs are docked.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/matching/model_source.h"
#include "records.h"

namespace tessera::worker {

class PairKeypoints {
 public:
  /// `reads`: key points are read from `models` for the pairs that need them; otherwise all come by add().
  PairKeypoints(const MatchRecord& match, int pad_levels, const ModelSource& models, bool reads);

  /// Adds the key points of the shard's next shapes.
  void add(const std::vector<ShapeModel>& models);

  /// The key points of each pair: x of its 2 n + 1 points, then y, in steps of the shape's keypoint_step.
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
