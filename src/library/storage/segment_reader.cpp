#include "library/storage/segment_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "library/storage/library_check.h"
#include "library/storage/library_layout.h"

namespace tessera {
namespace {

template <class T>
T value_at(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Whether the check at the end of a row is right. `bytes` includes the check.
bool is_row_of(const std::uint8_t* row, std::size_t bytes, std::uint64_t owner) {
  const std::size_t content = bytes - sizeof(RowCheck);
  return value_at<RowCheck>(row + content) == row_check(row, content, owner);
}

bool are_keypoints_of(const std::uint8_t* row, std::size_t bytes, std::uint64_t owner, std::uint64_t sample) {
  const std::size_t content = bytes - sizeof(KeypointCheck);
  return value_at<KeypointCheck>(row + content) == KeypointCheck(row_check(row, content, owner, sample));
}

/// PAD number `j` of a row with `samples` PADs.
LibraryPad pad_at(const std::uint8_t* row, std::size_t j, std::size_t samples, std::size_t elements) {
  const std::uint8_t* const lengths = row + samples * elements * sizeof(std::uint16_t);
  const std::uint8_t* const signs = lengths + samples * sizeof(float);
  LibraryPad pad;
  const std::uint8_t* const own = row + j * elements * sizeof(std::uint16_t);
  // always as many, so that the compiler makes no call for each PAD
  for (std::size_t e = 0; e < pad.pad.element.size(); ++e) {
    if (e < elements) pad.pad.element[e] = value_at<std::uint16_t>(own + e * sizeof(std::uint16_t));
  }
  pad.scale_length = value_at<float>(lengths + j * sizeof(float));
  pad.convexity = float(value_at<std::int8_t>(signs + j));
  return pad;
}

/// False where a number cannot be one of a PAD.
bool is_library_pad(const LibraryPad& pad) {
  return std::abs(pad.convexity) <= 1 && pad.pad == library_pad(pad.pad) &&
         pad.scale_length == library_length(pad.scale_length) &&
         all_within(&pad.scale_length, 1, layout::kLeastLength, 2 * layout::kMaxCoordinate);
}

bool is_permutation_of_all(std::span<const std::uint32_t> order) {
  std::vector<bool> seen(order.size(), false);
  for (const std::uint32_t place : order) {
    if (place >= seen.size() || seen[place]) return false;
    seen[place] = true;
  }
  return true;
}

}  // namespace

/// Shapes [first, first + owners.size()) of a segment.
struct SegmentReader::Part {
  std::uint32_t segment;
  std::uint32_t first;
  std::span<const SegmentOwner> owners;
};

std::vector<SegmentReader::Part> SegmentReader::parts_of(const ShapeRange& range,
                                                         std::span<const SegmentOwner> owners) {
  std::vector<Part> parts;
  for (std::uint32_t at = range.begin, next = at; at < range.end; at = next) {
    const std::uint32_t segment = at / kSegmentShapes;
    next = std::min(range.end, (segment + 1) * kSegmentShapes);
    parts.push_back({segment, at % kSegmentShapes, owners.subspan(at - range.begin, next - at)});
  }
  return parts;
}

SegmentReader::SegmentReader(std::string path, std::shared_ptr<const FileDescriptor> file, SegmentKind kind,
                             std::uint32_t shapes, std::vector<std::uint64_t> begins)
    : path_(std::move(path)),
      file_(std::move(file)),
      kind_(std::move(kind)),
      shapes_(shapes),
      begins_(std::move(begins)),
      whole_(kind_, kSegmentShapes),
      last_(kind_, shapes - (std::uint32_t(begins_.size()) - 1) * kSegmentShapes) {}

void SegmentReader::fail(const std::string& what) const {
  throw InputError(path_ + ": models: " + what + "; build the library again with tessera library build");
}

const SegmentLayout& SegmentReader::layout_of(std::uint32_t segment) const {
  return segment + 1 == begins_.size() ? last_ : whole_;
}

const LevelSection& SegmentReader::section_of(const SegmentLayout& layout, int level) const {
  return *std::find_if(layout.levels.begin(), layout.levels.end(),
                       [&](const LevelSection& section) { return section.level == level; });
}

void SegmentReader::read_into(void* data, std::uint32_t segment, std::size_t at, std::size_t bytes) const {
  const std::span to(static_cast<std::uint8_t*>(data), bytes);
  if (read_at(path_, *file_, begins_[segment] + at, to) < bytes) fail("the file ends too early");
}

std::vector<std::uint8_t> SegmentReader::read(std::uint32_t segment, std::size_t at, std::size_t bytes) const {
  std::vector<std::uint8_t> data(bytes);
  read_into(data.data(), segment, at, bytes);
  return data;
}

/// Reads a row for each shape, from `section_at` on.
template <class Row, class SetRow>
void SegmentReader::add_rows(std::span<ShapeModel> models, const Part& part, std::size_t section_at, SetRow set_row,
                             const char* what) const {
  constexpr std::size_t kRow = sizeof(Row) + sizeof(RowCheck);
  const auto rows = read(part.segment, section_at + part.first * kRow, models.size() * kRow);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::uint8_t* const row = rows.data() + i * kRow;
    if (!is_row_of(row, kRow, part.owners[i].contour) || !set_row(models[i], value_at<Row>(row))) {
      fail(std::string(what) + " is damaged");
    }
  }
}

void SegmentReader::add_sketches(std::span<ShapeModel> models, const Part& part) const {
  add_rows<SketchRow>(models, part, layout_of(part.segment).sketches_at, set_sketch, "a sketch");
}

void SegmentReader::add_contours(std::span<ShapeModel> models, const Part& part) const {
  add_rows<ContourRow>(models, part, layout_of(part.segment).contours_at, set_contour, "a contour");
}

/// Calls set_pad(number of the shape in the part, number of the PAD in the level, LibraryPad) for all PADs.
template <class SetPad>
void SegmentReader::read_pads(const Part& part, int level, SetPad&& set_pad) const {
  const SegmentLayout& layout = layout_of(part.segment);
  const LevelSection& section = section_of(layout, level);
  const auto rows =
      read(part.segment, section.pads_at + part.first * section.pads_row, part.owners.size() * section.pads_row);
  for (std::size_t i = 0; i < part.owners.size(); ++i) {
    const std::uint8_t* const row = rows.data() + i * section.pads_row;
    bool fits = is_row_of(row, section.pads_row, part.owners[i].level[std::size_t(level)]);
    for (std::size_t j = 0; j < section.samples; ++j) {
      const LibraryPad pad = pad_at(row, j, section.samples, layout.elements);
      fits = fits && is_library_pad(pad);
      set_pad(i, j, pad);
    }
    if (!fits) fail("PADs are damaged");
  }
}

std::vector<LibraryPad> SegmentReader::pads(const ShapeRange& range, const std::vector<int>& levels,
                                            std::span<const SegmentOwner> owners) const {
  std::size_t sources = 0;  // of one shape
  for (const int level : levels) sources += section_of(whole_, level).samples;
  std::vector<LibraryPad> pads(range.size() * sources);
  for (const Part& part : parts_of(range, owners)) {
    LibraryPad* to = pads.data() + (part.segment * kSegmentShapes + part.first - range.begin) * sources;
    for (const int level : levels) {
      read_pads(part, level, [&](std::size_t i, std::size_t j, const LibraryPad& pad) { to[i * sources + j] = pad; });
      to += section_of(whole_, level).samples;
    }
  }
  return pads;
}

void SegmentReader::add_level(std::span<ShapeModel> models, const Part& part, int level, bool keypoints) const {
  const SegmentLayout& layout = layout_of(part.segment);
  const LevelSection& section = section_of(layout, level);
  for (ShapeModel& model : models) model.levels.push_back({level, std::vector<ModelSample>(section.samples)});
  read_pads(part, level, [&](std::size_t i, std::size_t j, const LibraryPad& pad) {
    ModelSample& sample = models[i].levels.back().samples[j];
    sample.pad = pad.pad;
    sample.scale_length = pad.scale_length;
    sample.convexity = pad.convexity;
  });
  if (!keypoints) return;
  const std::size_t of_shape = section.samples * section.keypoints_row;
  const auto points = read(part.segment, section.keypoints_at + part.first * of_shape, models.size() * of_shape);
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (std::size_t j = 0; j < section.samples; ++j) {
      const std::uint8_t* const row = points.data() + i * of_shape + j * section.keypoints_row;
      if (!are_keypoints_of(row, section.keypoints_row, part.owners[i].level[std::size_t(level)], j)) {
        fail("key points are damaged");
      }
      std::memcpy(models[i].levels.back().samples[j].keypoint.data(), row,
                  layout.keypoint_points * sizeof(ModelSample::Step));
    }
  }
}

std::vector<ShapeModel> SegmentReader::models(const ShapeRange& range, const std::vector<int>& levels,
                                              const ModelParts& parts, std::span<const SegmentOwner> owners) const {
  std::vector<ShapeModel> models(range.size());
  std::span<ShapeModel> rest(models);
  for (const Part& part : parts_of(range, owners)) {
    const std::span<ShapeModel> own = rest.first(part.owners.size());
    add_sketches(own, part);
    if (parts.contours) add_contours(own, part);
    if (parts.pads) {
      for (const int level : levels) add_level(own, part, level, parts.keypoints);
    }
    rest = rest.subspan(own.size());
  }
  return models;
}

std::vector<ShapeModel> SegmentReader::contours(const ShapeRange& range, std::span<const SegmentOwner> owners) const {
  std::vector<ShapeModel> models(range.size());
  add_contours(models, {range.begin / kSegmentShapes, range.begin % kSegmentShapes, owners});
  return models;
}

void SegmentReader::keypoints(ShapeId shape, int level, std::uint32_t sample, const SegmentOwner& owner,
                              ModelSample::Step* points) const {
  const std::uint32_t segment = index_of(shape) / kSegmentShapes;
  const SegmentLayout& layout = layout_of(segment);
  const LevelSection& section = section_of(layout, level);
  const std::size_t row = std::size_t(index_of(shape) % kSegmentShapes) * section.samples + sample;
  std::array<std::uint8_t, sizeof(Keypoints)> bytes;
  read_into(bytes.data(), segment, section.keypoints_at + row * section.keypoints_row, section.keypoints_row);
  if (!are_keypoints_of(bytes.data(), section.keypoints_row, owner.level[std::size_t(level)], sample)) {
    fail("key points are damaged");
  }
  std::memcpy(points, bytes.data(), layout.keypoint_points * sizeof(ModelSample::Step));
}

std::vector<std::uint32_t> SegmentReader::pad_order(const ShapeRange& range, int level) const {
  const std::uint32_t segment = range.begin / kSegmentShapes;
  const SegmentLayout& layout = layout_of(segment);
  const LevelSection& section = section_of(layout, level);
  std::vector<std::uint32_t> order(layout.shapes * section.samples);
  read_into(order.data(), segment, section.order_at, order.size() * sizeof order[0]);
  if (!is_permutation_of_all(order)) fail("an order of PADs is damaged");
  const auto first = std::uint32_t((range.begin % kSegmentShapes) * section.samples);
  const auto count = std::uint32_t(range.size() * section.samples);
  if (count == order.size()) return order;
  std::vector<std::uint32_t> own;
  own.reserve(count);
  for (const std::uint32_t place : order) {
    if (place - first < count) own.push_back(place - first);
  }
  return own;
}

}  // namespace tessera
