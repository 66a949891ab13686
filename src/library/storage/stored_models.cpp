#include "library/storage/stored_models.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/rank_pool.h"

namespace tessera {
namespace {

/// One thread at a time reads so many, each in a few microseconds.
constexpr std::size_t kPadsAtATime = 512;
constexpr std::uint32_t kContoursAtATime = 32;

/// Consecutive shapes of a list that lie within one segment: one call to the file reads all of them.
struct Run {
  std::size_t place;  // of the first shape in the list
  ShapeRange shapes;
};

std::vector<Run> runs_of(std::span<const ShapeId> shapes) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::uint32_t shape = index_of(shapes[i]);
    const bool goes_on = !runs.empty() && shape == runs.back().shapes.end && shape % kSegmentShapes != 0 &&
                         runs.back().shapes.size() < kContoursAtATime;
    if (!goes_on) runs.push_back({i, {shape, shape}});
    ++runs.back().shapes.end;
  }
  return runs;
}

}  // namespace

StoredModels::StoredModels(std::shared_ptr<const SegmentReader> segments, const MatchingContext& context, Owners owners)
    : segments_(std::move(segments)),
      levels_(context.levels),
      owners_of_(std::move(owners)) {}

std::vector<SegmentOwner> StoredModels::owners_in(const ShapeRange& range) const {
  if (owners_.empty()) first_owned_ = range.begin;
  const std::uint32_t owned_end = first_owned_ + std::uint32_t(owners_.size());
  if (range.begin >= first_owned_ && range.end <= owned_end) {
    const auto kept = kept_owners(range);
    return {kept.begin(), kept.end()};
  }
  std::vector<SegmentOwner> owners = owners_of_(range);
  if (range.begin == owned_end) owners_.insert(owners_.end(), owners.begin(), owners.end());
  return owners;
}

std::span<const SegmentOwner> StoredModels::kept_owners(const ShapeRange& range) const {
  if (range.begin < first_owned_ || range.end - first_owned_ > owners_.size()) {
    throw std::out_of_range("single models of shapes that no matcher has");
  }
  return std::span(owners_).subspan(range.begin - first_owned_, range.size());
}

std::vector<ShapeModel> StoredModels::models(const ShapeRange& range, const ModelParts& parts) const {
  return segments_->models(range, levels_, parts, owners_in(range));
}

std::vector<LibraryPad> StoredModels::pads(const ShapeRange& range) const {
  return segments_->pads(range, levels_, owners_in(range));
}

std::vector<std::uint32_t> StoredModels::pad_order(const ShapeRange& range, std::size_t level) const {
  return segments_->pad_order(range, levels_[level]);
}

std::vector<ShapeModel> StoredModels::contours(std::span<const ShapeId> shapes) const {
  std::vector<ShapeModel> models(shapes.size());
  const std::vector<Run> runs = runs_of(shapes);
  parallel_for(runs.size(), [&](std::size_t i) {
    std::vector<ShapeModel> read = segments_->contours(runs[i].shapes, kept_owners(runs[i].shapes));
    std::move(read.begin(), read.end(), models.begin() + std::ptrdiff_t(runs[i].place));
  });
  return models;
}

std::vector<ModelSample::Step> StoredModels::keypoints(std::span<const PadName> pads) const {
  const std::size_t points = std::size_t(2 * segments_->kind().pad_levels + 1);
  std::vector<ModelSample::Step> steps(pads.size() * points);
  parallel_for_portions(pads.size(), kPadsAtATime, [&](std::size_t i) {
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

}  // namespace tessera
