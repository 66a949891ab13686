// The layout of the models of up to kSegmentShapes consecutive shapes in a library file, stored so that ranks need not make
// them again (docs/library-format.md, "Models"). It has sections with rows of equal length. A number at the end of each row
// tells whether it is the row that was written for this shape. Numbers are stored as in memory, little-endian.
//   sketches, contours    a row for each shape
//   for each smoothing level:
//     pads                a row for each shape
//     keypoints           a row for each PAD
//     order               of an index of the level's PADs, shape by shape: uint32
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pad/pad_index.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_model.h"
#include "library/storage/shape_head.h"

namespace tessera {

static_assert(std::endian::native == std::endian::little, "segments are written as they lie in memory");

/// Rises with every change of the models or of their layout. Models of other versions are not read.
inline constexpr int kModelsVersion = 2;

/// The shape that a row belongs to: digests of all data of the shape that its models are made of.
struct SegmentOwner {
  std::uint64_t contour = 0;  // outline, field, and the lengths and colours of the head
  std::array<std::uint64_t, kSmoothingLevels.size()> level{};
};

/// `head`: its lengths and colours count.
SegmentOwner segment_owner(const Shape& head, const PartDigests& digests);

/// Contour points and numbers used for the first, cheap test of a docking.
struct SketchRow {
  float perimeter;
  float radius;
  Vec2 disc_centre;
  float disc_radius;
  std::uint32_t interior_points;
  Lab mean_colour;
  float colour_cell;
  std::array<Vec2, kBoundaryPoints / kCoarseStride> boundary;
  std::array<Vec2, (kMaxInteriorPoints + kInteriorStride - 1) / kInteriorStride> interior;
};

/// Contour points at which dockings begin, and points and colours for their refinement.
struct ContourRow {
  std::uint32_t interior_points;
  std::array<Vec2, kBoundaryPoints> boundary;
  std::array<Vec2, kBoundaryPoints> tangent;
  std::array<Vec2, kMaxInteriorPoints> interior;
  std::array<Vec2, kColourCells> colour_at;
  std::array<Lab, kColourCells> colour;
  std::array<float, kColourCells> colour_part;
};

/// The kind of models that a file holds.
struct SegmentKind {
  int pad_levels = 5;
  std::vector<int> levels;  // smoothing levels, ascending

  friend bool operator==(const SegmentKind&, const SegmentKind&) = default;
};

using RowCheck = std::uint64_t;       // at the end of a row
using KeypointCheck = std::uint32_t;  // the lower half of a RowCheck

/// The place of one smoothing level in a segment, in bytes.
struct LevelSection {
  int level;
  std::size_t samples;  // of one shape
  std::size_t pads_at;
  std::size_t pads_row;  // elements, then scale lengths (float), then convexities (int8), the check
  std::size_t keypoints_at;
  std::size_t keypoints_row;  // steps, the check
  std::size_t order_at;
};

struct SegmentLayout {
  SegmentLayout(const SegmentKind& kind, std::uint32_t shapes);

  std::uint32_t shapes;
  std::size_t elements;         // of one PAD
  std::size_t keypoint_points;  // of one PAD
  std::size_t sketches_at = 0;
  std::size_t contours_at;
  std::vector<LevelSection> levels;
  std::size_t bytes;  // of the segment

  static constexpr std::size_t kSketchBytes = sizeof(SketchRow) + sizeof(RowCheck);
  static constexpr std::size_t kContourBytes = sizeof(ContourRow) + sizeof(RowCheck);
};

/// The number at the end of a row. `number`: of a PAD within its level; 0 for other rows.
RowCheck row_check(const std::uint8_t* row, std::size_t bytes, std::uint64_t owner, std::uint64_t number = 0);

SketchRow sketch_row(const ShapeModel& model);
ContourRow contour_row(const ShapeModel& model);
/// False where the row breaks a limit of the library's format.
bool set_sketch(ShapeModel& model, const SketchRow& row);
bool set_contour(ShapeModel& model, const ContourRow& row);

}  // namespace tessera
