// A part of the library as the kernels read it: structure of arrays, in vectors of 16 (kernels/records.h).
#pragma once

#include <cstddef>
#include <vector>

#include "core/matching_context.h"
#include "core/shape_model.h"
#include "records.h"

namespace tessera::worker {

struct Shard {
  /// All but the field's place.
  MatchRecord match;
  /// By shape, level, element, sample: the PAD's elements, then the length that estimates the scale, then convexity.
  std::vector<float> pads;
  /// By shape and source: x of the key points, then y. Shape units.
  std::vector<float> keypoints;
  /// By shape: the sets of points of RecordSizes. Shape units.
  std::vector<float> contours;
  std::vector<ShapeRecord> shapes;

  /// On the device.
  std::size_t bytes() const {
    return (pads.size() + keypoints.size() + contours.size()) * sizeof(float) + shapes.size() * sizeof(ShapeRecord);
  }
};

/// `models[i]` is library shape first_shape + i; they have the context's levels, each with as many samples as
/// kSmoothingLevels says (else std::logic_error).
Shard make_shard(const MatchingContext& context, std::uint32_t first_shape, const std::vector<ShapeModel>& models);

/// What Shard::bytes() of so many shapes will be.
std::size_t shard_bytes(const MatchingContext& context, std::size_t shapes);

/// The level whose interval estimates the scale before any alignment, as in core/pair_selection.cpp.
int scale_level(int pad_levels);

}  // namespace tessera::worker
