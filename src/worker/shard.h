// Some shapes of the library as the kernels read them: structure of arrays, in vectors of 16 (kernels/records.h).
#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_model.h"
#include "records.h"
#include "worker/index_rows.h"

namespace tessera::worker {

struct Shard {
  std::vector<IndexedPad> pads;  // by shape and source
  /// By shape and source: x of the key points, then y, in steps of the shape's keypoint_step.
  std::vector<std::int16_t> keypoints;
  /// By shape: the sets of points of RecordSizes. Shape units.
  std::vector<float> contours;
  std::vector<ShapeRecord> shapes;

  /// What it takes on the device, without the index.
  std::size_t bytes() const {
    return keypoints.size() * sizeof(std::int16_t) + contours.size() * sizeof(float) +
           shapes.size() * sizeof(ShapeRecord);
  }
};

/// The record with everything but the field's place.
MatchRecord make_match_record(const MatchingContext& context, const ShapeRange& shapes);

/// Makes the shard of models that have the levels of `match`, each with as many samples as kSmoothingLevels says (else
/// std::logic_error).
Shard make_shard(const MatchRecord& match, int pad_levels, const std::vector<ShapeModel>& models);

/// What so many shapes will take on a device, with their index.
std::size_t shard_bytes(const MatchingContext& context, std::size_t shapes);

}  // namespace tessera::worker
