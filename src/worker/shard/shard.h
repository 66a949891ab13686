// Some shapes of the library in the form that the kernels read: structure of arrays, in vectors of 16 (kernels/records.h).
#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_model.h"
#include "records.h"
#include "worker/shard/index_rows.h"

namespace tessera::worker {

struct Shard {
  IndexedPads pads;             // by shape and source
  std::vector<float> sketches;  // by shape: the point sets of RecordSizes, shape units
  std::vector<ShapeRecord> shapes;

  /// The bytes that it takes on the device, without index and contours.
  std::size_t bytes() const { return sketches.size() * sizeof(float) + shapes.size() * sizeof(ShapeRecord); }
};

/// Appends the point sets of a model's contour (RecordSizes), in shape units.
void append_contour(std::vector<float>& contours, const ShapeModel& model);

/// The numbers of a PAD's key points: x and y of 2 n + 1 points.
inline std::size_t keypoint_numbers(int pad_levels) { return std::size_t(2 * (2 * pad_levels + 1)); }

/// Appends the key points of all the model's PADs, x and then y of each PAD, in steps of the shape's keypoint_step.
void append_keypoints(std::vector<std::int16_t>& keypoints, const ShapeModel& model, int pad_levels);

/// Makes the record, but for the field's place.
MatchRecord make_match_record(const MatchingContext& context, const ShapeRange& shapes);
/// Sets the numbers of the record that depend on sizes, from the present context.
void set_sizes(MatchRecord& match, const MatchingContext& context);

/// Makes the shard of these models. They must have the levels of `match`, each with as many samples as kSmoothingLevels
/// says, or std::logic_error is thrown. `pads`: the PADs of these models; where they are given, models need no levels.
Shard make_shard(const MatchRecord& match, const IndexKind& kind, const std::vector<ShapeModel>& models,
                 std::vector<LibraryPad> pads = {});

/// The number of shapes that keep contours and key points in memory, where these could also be read from the library's file.
struct HeldShapes {
  /// A shard of at most so many shapes has all of them from the start: 5 KB a shape on the device and 14 KB in memory.
  std::uint32_t most_whole = 65536;
  /// A larger shard keeps so many contours on the device (77 MB), or as many as one question needs. The dockings that a
  /// round refines and measures have some thousand shapes.
  std::uint32_t contours = 16384;

  bool holds_all(std::size_t shapes) const { return shapes <= most_whole; }
};

// Otherwise the random dockings of a question would need all contours of a library, read one by one.
static_assert(HeldShapes().most_whole >= kWholeDeck);

/// The bytes that so many shapes will take on a device, with their index and contours, and in memory beside it. `reads`:
/// contours and key points can be read when needed.
struct ShardBytes {
  std::size_t device = 0;
  std::size_t host = 0;
  std::size_t largest_buffer = 0;  // on the device
};
ShardBytes shard_bytes(const MatchingContext& context, std::size_t shapes, bool reads);

}  // namespace tessera::worker
