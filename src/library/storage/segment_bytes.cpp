#include "library/storage/segment_bytes.h"

#include <algorithm>
#include <cstring>

#include "core/base/rank_pool.h"

namespace tessera {
namespace {

/// Writes values one after the other, from `at` on.
class RowWriter {
 public:
  explicit RowWriter(std::uint8_t* at) : begin_(at), at_(at) {}

  template <class T>
  void put(const T& value) {
    std::memcpy(at_, &value, sizeof value);
    at_ += sizeof value;
  }

  RowCheck check(std::uint64_t owner, std::uint64_t number = 0) const {
    return row_check(begin_, std::size_t(at_ - begin_), owner, number);
  }

 private:
  std::uint8_t* begin_;
  std::uint8_t* at_;
};

void put_pads(std::uint8_t* at, const ModelLevel& level, std::size_t elements, std::uint64_t owner) {
  RowWriter row(at);
  for (const ModelSample& sample : level.samples) {
    for (std::size_t e = 0; e < elements; ++e) row.put(sample.pad.element[e]);
  }
  for (const ModelSample& sample : level.samples) row.put(sample.scale_length);
  for (const ModelSample& sample : level.samples) row.put(std::int8_t((sample.convexity > 0) - (sample.convexity < 0)));
  row.put(row.check(owner));
}

void put_keypoints(std::uint8_t* at, const ModelSample& sample, std::size_t points, std::uint64_t owner,
                   std::uint64_t number) {
  RowWriter row(at);
  for (std::size_t i = 0; i < points; ++i) row.put(sample.keypoint[i]);
  row.put(KeypointCheck(row.check(owner, number)));
}

void put_order(std::uint8_t* at, std::span<const ShapeModel> models, std::size_t level, std::size_t elements) {
  std::vector<PadBytes> pads;
  for (const ShapeModel& model : models) {
    for (const ModelSample& sample : model.levels[level].samples) {
      pads.push_back(pad_bytes(sample.pad, sample.scale_length, sample.convexity));
    }
  }
  const std::vector<std::uint32_t> order = pad_order(pads, int(elements));
  std::memcpy(at, order.data(), order.size() * sizeof order[0]);
}

}  // namespace

std::vector<std::uint8_t> segment_bytes(const SegmentKind& kind, std::span<const ShapeModel> models,
                                        std::span<const SegmentOwner> owners) {
  const SegmentLayout layout(kind, std::uint32_t(models.size()));
  std::vector<std::uint8_t> bytes(layout.bytes);
  for (std::size_t i = 0; i < models.size(); ++i) {
    RowWriter sketch(bytes.data() + layout.sketches_at + i * SegmentLayout::kSketchBytes);
    sketch.put(sketch_row(models[i]));
    sketch.put(sketch.check(owners[i].contour));
    RowWriter contour(bytes.data() + layout.contours_at + i * SegmentLayout::kContourBytes);
    contour.put(contour_row(models[i]));
    contour.put(contour.check(owners[i].contour));
  }
  parallel_for(layout.levels.size(), [&](std::size_t k) {
    const LevelSection& section = layout.levels[k];
    for (std::size_t i = 0; i < models.size(); ++i) {
      const ModelLevel& level = models[i].levels[k];
      const std::uint64_t owner = owners[i].level[std::size_t(section.level)];
      put_pads(bytes.data() + section.pads_at + i * section.pads_row, level, layout.elements, owner);
      for (std::size_t j = 0; j < section.samples; ++j) {
        put_keypoints(bytes.data() + section.keypoints_at + (i * section.samples + j) * section.keypoints_row,
                      level.samples[j], layout.keypoint_points, owner, j);
      }
    }
    put_order(bytes.data() + section.order_at, models, k, layout.elements);
  });
  return bytes;
}

}  // namespace tessera
