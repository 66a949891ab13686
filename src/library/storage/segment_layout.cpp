#include "library/storage/segment_layout.h"

#include <algorithm>
#include <span>

#include "core/settings/tuning.h"
#include "library/storage/library_check.h"
#include "library/storage/library_layout.h"
#include "library/storage/part_digest.h"

namespace tessera {
namespace {

template <class Rows>
bool are_coordinates(const Rows& points) {
  return all_within(points.data(), points.size(), -layout::kMaxCoordinate, layout::kMaxCoordinate);
}

bool is_colour(const Lab& lab) { return all_within(&lab.lightness, 3, -layout::kMaxLab, layout::kMaxLab); }

bool is_length(float length) { return all_within(&length, 1, 0, layout::kMaxCoordinate); }

}  // namespace

SegmentLayout::SegmentLayout(const SegmentKind& kind, std::uint32_t count)
    : shapes(count),
      elements(std::size_t(2 * (kind.pad_levels - 1))),
      keypoint_points(std::size_t(2 * kind.pad_levels + 1)) {
  contours_at = sketches_at + count * kSketchBytes;
  bytes = contours_at + count * kContourBytes;
  const auto section = [&](std::size_t rows, std::size_t row_bytes) {
    const std::size_t at = bytes;
    bytes += rows * row_bytes;
    return at;
  };
  for (const int k : kind.levels) {
    LevelSection level{};
    level.level = k;
    level.samples = std::size_t(kSmoothingLevels[std::size_t(k)].samples);
    level.pads_row = level.samples * (elements * sizeof(std::uint16_t) + sizeof(float) + 1) + sizeof(RowCheck);
    level.pads_at = section(count, level.pads_row);
    level.keypoints_row = keypoint_points * sizeof(ModelSample::Step) + sizeof(KeypointCheck);
    level.keypoints_at = section(count * level.samples, level.keypoints_row);
    level.order_at = section(count * level.samples, sizeof(std::uint32_t));
    levels.push_back(level);
  }
}

SegmentOwner segment_owner(const Shape& head, const PartDigests& digests) {
  const std::array lengths{head.perimeter, head.radius};
  const std::uint64_t of_head = PartDigest()
                                    .add(std::span<const float>(lengths))
                                    .add(std::span<const float>(head.mean_lab))
                                    .add(std::span<const std::uint8_t>(head.colour_grid.bytes))
                                    .value();
  SegmentOwner owner;
  owner.contour = PartDigest().add(digests[0]).add(digests[1]).add(of_head).value();
  for (std::size_t k = 0; k < owner.level.size(); ++k) {
    owner.level[k] = PartDigest().add(digests[2 + k]).add(of_head).value();
  }
  return owner;
}

RowCheck row_check(const std::uint8_t* row, std::size_t bytes, std::uint64_t owner, std::uint64_t number) {
  return PartDigest().add(std::span(row, bytes)).add(owner).add(number).value();
}

SketchRow sketch_row(const ShapeModel& model) {
  SketchRow row{};
  row.perimeter = model.perimeter;
  row.radius = model.radius;
  row.disc_centre = model.disc_centre;
  row.disc_radius = model.disc_radius;
  row.interior_points = std::uint32_t(model.interior.size());
  row.mean_colour = model.colour.mean;
  row.colour_cell = model.colour.cell;
  for (std::size_t i = 0; i < row.boundary.size(); ++i) row.boundary[i] = model.boundary[i * kCoarseStride];
  for (std::size_t i = 0; i * kInteriorStride < model.interior.size(); ++i) {
    row.interior[i] = model.interior[i * kInteriorStride];
  }
  return row;
}

ContourRow contour_row(const ShapeModel& model) {
  ContourRow row{};
  row.interior_points = std::uint32_t(model.interior.size());
  row.boundary = model.boundary;
  row.tangent = model.tangent;
  std::copy(model.interior.begin(), model.interior.end(), row.interior.begin());
  row.colour_at = model.colour.at;
  row.colour = model.colour.colour;
  row.colour_part = model.colour.part;
  return row;
}

bool set_sketch(ShapeModel& model, const SketchRow& row) {
  const bool fits = is_length(row.perimeter) && is_length(row.radius) && is_length(row.disc_radius) &&
                    is_length(row.colour_cell) && is_colour(row.mean_colour) &&
                    row.interior_points <= kMaxInteriorPoints && are_coordinates(std::array{row.disc_centre}) &&
                    are_coordinates(row.boundary) && are_coordinates(row.interior);
  if (!fits) return false;
  model.perimeter = row.perimeter;
  model.radius = row.radius;
  model.disc_centre = row.disc_centre;
  model.disc_radius = row.disc_radius;
  model.colour.mean = row.mean_colour;
  model.colour.cell = row.colour_cell;
  for (std::size_t i = 0; i < row.boundary.size(); ++i) model.boundary[i * kCoarseStride] = row.boundary[i];
  model.interior.resize(row.interior_points);
  for (std::size_t i = 0; i * kInteriorStride < model.interior.size(); ++i) {
    model.interior[i * kInteriorStride] = row.interior[i];
  }
  return true;
}

bool set_contour(ShapeModel& model, const ContourRow& row) {
  const bool fits = are_coordinates(row.boundary) && are_coordinates(row.tangent) && are_coordinates(row.interior) &&
                    are_coordinates(row.colour_at) && all_within(row.colour_part.data(), kColourCells, 0, 1) &&
                    std::all_of(row.colour.begin(), row.colour.end(), is_colour) &&
                    row.interior_points <= kMaxInteriorPoints;
  if (!fits) return false;
  model.boundary = row.boundary;
  model.tangent = row.tangent;
  model.interior.assign(row.interior.begin(), row.interior.begin() + row.interior_points);
  model.colour.at = row.colour_at;
  model.colour.colour = row.colour;
  model.colour.part = row.colour_part;
  return true;
}

}  // namespace tessera
