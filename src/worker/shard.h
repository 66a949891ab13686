// Some shapes of the library as the kernels read them: structure of arrays, in vectors of 16 (kernels/records.h).
#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_model.h"
#include "records.h"

namespace tessera::worker {

struct Shard {
  /// The filter (core/pad/pad_filter.h), by shape and block of kFilterLanes sources: a row for each element of the
  /// PADs, then one for the lengths that estimate the scale, one for the signs.
  std::vector<std::uint8_t> pad_bytes;
  /// By shape and source: the PAD's elements, steps, and zeros up to pad_row().
  std::vector<std::uint16_t> pads;
  std::vector<PadRecord> pad_records;
  /// By shape and source: x of the key points, then y, in steps of the shape's keypoint_step.
  std::vector<std::int16_t> keypoints;
  /// By shape: the sets of points of RecordSizes. Shape units.
  std::vector<float> contours;
  std::vector<ShapeRecord> shapes;

  /// What it takes on the device.
  std::size_t bytes() const {
    return pad_bytes.size() + (pads.size() + keypoints.size()) * sizeof(std::uint16_t) +
           pad_records.size() * sizeof(PadRecord) + contours.size() * sizeof(float) +
           shapes.size() * sizeof(ShapeRecord);
  }
};

/// Elements of a PAD on the device: a vector of 8 or of 16.
constexpr int pad_row(int pad_levels) { return 2 * (pad_levels - 1) <= 8 ? 8 : 16; }

/// The record with everything but the field's place.
MatchRecord make_match_record(const MatchingContext& context, const ShapeRange& shapes);

/// Makes the shard of models that have the levels of `match`, each with as many samples as kSmoothingLevels says (else
/// std::logic_error).
Shard make_shard(const MatchRecord& match, int pad_levels, const std::vector<ShapeModel>& models);

/// What Shard::bytes() of so many shapes will be.
std::size_t shard_bytes(const MatchingContext& context, std::size_t shapes);

}  // namespace tessera::worker
