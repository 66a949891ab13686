// Some shapes of the library as the kernels read them: structure of arrays, in vectors of 16 (kernels/records.h).
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
  std::vector<float> sketches;  // by shape: the sets of points of RecordSizes, shape units
  std::vector<ShapeRecord> shapes;

  /// What it takes on the device, without index and contours.
  std::size_t bytes() const { return sketches.size() * sizeof(float) + shapes.size() * sizeof(ShapeRecord); }
};

/// The sets of points of a model's contour (RecordSizes) behind others. Shape units.
void append_contour(std::vector<float>& contours, const ShapeModel& model);

/// Of a PAD: x and y of its 2 n + 1 key points.
inline std::size_t keypoint_numbers(int pad_levels) { return std::size_t(2 * (2 * pad_levels + 1)); }

/// x of the key points of a PAD, then y, of all the model's PADs, in steps of the shape's keypoint_step.
void append_keypoints(std::vector<std::int16_t>& keypoints, const ShapeModel& model, int pad_levels);

/// The record with everything but the field's place.
MatchRecord make_match_record(const MatchingContext& context, const ShapeRange& shapes);
/// Those of its numbers that go by sizes, as they are in the context now.
void set_sizes(MatchRecord& match, const MatchingContext& context);

/// Makes the shard of models that have the levels of `match`, each with as many samples as kSmoothingLevels says (else
/// std::logic_error). `pads`: of these models; where there are any, models need no levels.
Shard make_shard(const MatchRecord& match, const IndexKind& kind, const std::vector<ShapeModel>& models,
                 std::vector<LibraryPad> pads = {});

/// How many shapes' contours and key points are kept where they can be read, too.
struct HeldShapes {
  /// A shard of no more has all of them from the start: 5 KB a shape on the device and 14 KB in memory.
  std::uint32_t most_whole = 65536;
  /// Of a larger one so many contours are on the device, 77 MB, or as many as one question needs: the dockings of a
  /// round that are refined and measured are of some thousand shapes.
  std::uint32_t contours = 16384;

  bool holds_all(std::size_t shapes) const { return shapes <= most_whole; }
};

// Else the random dockings of a question would need the contours of a whole library, one by one.
static_assert(HeldShapes().most_whole >= kWholeDeck);

/// What so many shapes will take: on a device, with their index and contours, and beside it in memory. `reads`:
/// contours and key points can be read.
struct ShardBytes {
  std::size_t device = 0;
  std::size_t host = 0;
  std::size_t largest_buffer = 0;  // on the device
};
ShardBytes shard_bytes(const MatchingContext& context, std::size_t shapes, bool reads);

}  // namespace tessera::worker
