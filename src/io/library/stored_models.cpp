#include "io/library/stored_models.h"

#include "io/parallel_for.h"

namespace tessera::io {
namespace {

/// Read by one thread at a time; a few microseconds each.
constexpr std::size_t kPadsAtATime = 512;
constexpr std::size_t kContoursAtATime = 32;

/// Calls body(i) for each i in [0, count), some of them one after the other on one of several threads.
template <class Body>
void in_portions(std::size_t count, std::size_t portion, Body&& body) {
  parallel_for((count + portion - 1) / portion, [&](std::size_t k) {
    for (std::size_t i = k * portion; i < std::min(count, (k + 1) * portion); ++i) body(i);
  });
}

}  // namespace

StoredModels::StoredModels(std::shared_ptr<const SegmentReader> segments, const MatchingContext& context, Owners owners)
    : segments_(std::move(segments)),
      levels_(context.levels),
      owners_of_(std::move(owners)) {}

std::vector<ShapeModel> StoredModels::models(const ShapeRange& range, const ModelParts& parts) const {
  const std::vector<SegmentOwner> owners = owners_of_(range);
  if (owners_.empty()) first_owned_ = range.begin;
  if (range.begin == first_owned_ + owners_.size()) owners_.insert(owners_.end(), owners.begin(), owners.end());
  return segments_->models(range, levels_, parts, owners);
}

std::vector<std::uint32_t> StoredModels::pad_order(const ShapeRange& range, std::size_t level) const {
  return segments_->pad_order(range, levels_[level]);
}

std::vector<ShapeModel> StoredModels::contours(std::span<const ShapeId> shapes) const {
  std::vector<ShapeModel> models(shapes.size());
  in_portions(shapes.size(), kContoursAtATime, [&](std::size_t i) {
    models[i] = segments_->contour(shapes[i], owners_.at(index_of(shapes[i]) - first_owned_));
  });
  return models;
}

std::vector<ModelSample::Step> StoredModels::keypoints(std::span<const PadName> pads) const {
  const std::size_t points = std::size_t(2 * segments_->kind().pad_levels + 1);
  std::vector<ModelSample::Step> steps(pads.size() * points);
  in_portions(pads.size(), kPadsAtATime, [&](std::size_t i) {
    std::uint32_t sample = pads[i].source;
    std::size_t k = 0;
    for (; sample >= std::uint32_t(kSmoothingLevels[std::size_t(levels_[k])].samples); ++k) {
      sample -= std::uint32_t(kSmoothingLevels[std::size_t(levels_[k])].samples);
    }
    segments_->keypoints(pads[i].shape, levels_[k], sample, owners_.at(index_of(pads[i].shape) - first_owned_),
                         steps.data() + i * points);
  });
  return steps;
}

}  // namespace tessera::io
